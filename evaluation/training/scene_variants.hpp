#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/ground_truth/scene_truth.hpp"

namespace symscene::bench {

/// The names of the variants of a scene that vary() makes.
std::vector<std::string> scene_variants();

/// Makes a variant of a scene, so that models see more than the simulated sensor:
/// "as-is" changes nothing; "posed" turns and shifts the scene at random, which moves the grid of
/// sampling, and drops the occupancy map; "noisy" adds 2° to 6° of noise with with_noise(). The
/// same seed makes the same variant.
void vary(const std::string& variant, std::uint64_t seed, Scene& scene, SceneTruth& truth);

/// A cloud with the noise of a worse depth sensor: normals are turned, correlated within 1 cm, and
/// points are shifted along their normals by 0.1 mm per degree. Throws InputError without normals.
PointCloud with_noise(PointCloud cloud, double degrees, std::uint64_t seed);

}  // namespace symscene::bench
