#pragma once

#include <cstdint>
#include <vector>

#include "symscene/simulation/camera_path.hpp"

namespace symscene {

/// Adds hand shake to `path`, which has `frame_rate` poses per second: smooth noise in the camera
/// frame, band-limited and bounded by four standard deviations. Throws InputError if `frame_rate`
/// is not positive or an option is out of range.
std::vector<Eigen::Isometry3d> shaken(std::vector<Eigen::Isometry3d> path, double frame_rate,
                                      const HandShakeOptions& options, std::uint64_t seed);

}  // namespace symscene
