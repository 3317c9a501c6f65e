#pragma once

#include <filesystem>

#include "symscene/simulation/simulation.hpp"

namespace symscene::bench {

struct TrueScene {
  Scene scene;
  SceneTruth truth;
};

/// Simulates a scene, or reads it from `cache` if it has been simulated with the same options; an
/// empty path disables the cache.
TrueScene simulated_scene(const SimulationOptions& options, const std::filesystem::path& cache);

}  // namespace symscene::bench
