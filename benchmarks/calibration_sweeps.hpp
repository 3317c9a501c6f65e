#pragma once

#include <cstdint>
#include <filesystem>

namespace symscene::bench {

/// Errors of the pose of a colour camera that pairs of images of a board give.
struct ColorPoseError {
  double shift = 0.0;  ///< [m]
  double turn = 0.0;   ///< [rad]
};
ColorPoseError color_pose_error(int images, std::uint64_t seed);

/// Objects found on tables, and how even the table is: by a camera without errors, one with errors,
/// and the same one calibrated. Writes the tabletop of the first sweep as pictures to a folder.
void measure_objects(int sweeps, int frames, const std::filesystem::path& pictures);

}  // namespace symscene::bench
