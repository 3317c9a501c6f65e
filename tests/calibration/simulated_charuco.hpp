#pragma once

#include <cmath>

#include "calibration/simulated_boards.hpp"
#include "symscene/calibration/charuco.hpp"

namespace symscene::calibration_test {

inline CharucoBoard the_charuco() { return {{6, 5, 0.03}, "DICT_5X5_50", 0.022}; }

inline CameraModel charuco_camera() {
  return {{480, 360, 429.0, 428.0, 237.0, 183.0}, {}, std::nullopt, std::nullopt};
}

/// A grey image of a printed board: the homography of its plane, 3×3 rays per pixel.
inline std::vector<std::uint8_t> rendered_charuco(const CameraModel& camera,
                                                  const CharucoBoard& board,
                                                  const Eigen::Isometry3d& T_camera_board) {
  constexpr Index resolution = 64;
  const CharucoPicture picture = charuco_picture(board, resolution);
  const CameraIntrinsics& K = camera.intrinsics;
  const Eigen::Isometry3d T_board_camera = T_camera_board.inverse();
  const double pixel = board.board.square / resolution;
  const auto brightness = [&](double u, double v) {
    const Eigen::Vector3d ray = T_board_camera.linear() * K.ray(u, v);
    const Eigen::Vector3d at = T_board_camera.translation();
    const Eigen::Vector3d p = at - ray * (at.z() / ray.z());
    // The first corner is the origin of the board, one square from the edges of the picture.
    const double x = std::floor(p.x() / pixel) + resolution;
    const double y = std::floor(p.y() / pixel) + resolution;
    if (x >= 0.0 && y >= 0.0 && x < picture.width && y < picture.height)
      return 30.0 + 200.0 / 255.0 *
                        picture.grey[static_cast<std::size_t>(y) * picture.width +
                                     static_cast<std::size_t>(x)];
    const double border = 0.5 * resolution;
    const bool is_paper =
        x >= -border && y >= -border && x < picture.width + border && y < picture.height + border;
    return is_paper ? 230.0 : 90.0;
  };
  std::vector<std::uint8_t> grey(K.pixels());
  for (Index v = 0; v < K.height; ++v) {
    for (Index u = 0; u < K.width; ++u) {
      double sum = 0.0;
      for (int k = 0; k < 9; ++k) sum += brightness(u + (k % 3 - 1) / 3.0, v + (k / 3 - 1) / 3.0);
      grey[std::size_t{v} * K.width + u] = static_cast<std::uint8_t>(sum / 9.0);
    }
  }
  return grey;
}

}  // namespace symscene::calibration_test
