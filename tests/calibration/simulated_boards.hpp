#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "symscene/calibration/intrinsic_calibration.hpp"

namespace symscene::calibration_test {

inline Board the_board() { return {8, 6, 0.03}; }

inline CameraModel true_camera() {
  CameraModel camera;
  camera.intrinsics = {640, 480, 572.0, 571.0, 316.0, 245.0};
  camera.distortion = {-0.12, 0.06, 0.001, -0.0015, 0.0};
  return camera;
}

/// Half the size, without distortion: quick to render.
inline CameraModel small_board_camera() {
  return {{320, 240, 286.0, 285.5, 158.0, 122.0}, {}, std::nullopt, std::nullopt};
}

inline Eigen::Vector2d shown_at(const CameraModel& camera, const Eigen::Vector3d& point) {
  const Eigen::Vector2d p = camera.distortion.distorted(point.hnormalized());
  return {camera.intrinsics.fx * p.x() + camera.intrinsics.cx,
          camera.intrinsics.fy * p.y() + camera.intrinsics.cy};
}

inline BoardImage board_image(const CameraModel& camera, const Board& board,
                              const Eigen::Isometry3d& T_camera_board, double noise,
                              std::uint64_t seed) {
  Random random(seed);
  BoardImage image;
  image.name = "image " + std::to_string(seed);
  for (std::size_t i = 0; i < board.corners(); ++i) {
    const Eigen::Vector2d jitter(random.normal(), random.normal());
    image.corners.push_back(shown_at(camera, T_camera_board * board.corner(i)) + noise * jitter);
  }
  return image;
}

/// A board wholly in view, turned by up to 40 degrees to any side.
inline Eigen::Isometry3d random_board_pose(const CameraModel& camera, const Board& board,
                                           Random& random) {
  const Eigen::Vector3d middle = board.corner(board.corners() - 1) / 2.0;
  for (;;) {
    const double turn = random.uniform(0.0, 6.28);
    const Eigen::Vector3d tilt_axis(std::cos(turn), std::sin(turn), 0.0);
    Eigen::Isometry3d pose(Eigen::AngleAxisd(random.uniform(0.1, 0.7), tilt_axis) *
                           Eigen::AngleAxisd(random.uniform(-0.5, 0.5), Eigen::Vector3d::UnitZ()));
    const double z = random.uniform(0.28, 0.55);
    const Eigen::Vector3d at(random.uniform(-0.5, 0.5) * z, random.uniform(-0.4, 0.4) * z, z);
    pose.translation() = at - pose.linear() * middle;
    const BoardImage image = board_image(camera, board, pose, 0.0, 1);
    const auto is_outside = [&](const Eigen::Vector2d& p) {
      const CameraIntrinsics& K = camera.intrinsics;
      return p.x() < 0.06 * K.width || p.y() < 0.08 * K.height || p.x() > 0.94 * K.width ||
             p.y() > 0.92 * K.height;
    };
    if (std::none_of(image.corners.begin(), image.corners.end(), is_outside)) return pose;
  }
}

inline std::vector<BoardImage> board_images(const CameraModel& camera, const Board& board,
                                            int count, double noise, std::uint64_t seed) {
  Random random(seed);
  std::vector<BoardImage> images;
  for (int i = 0; i < count; ++i) {
    const Eigen::Isometry3d pose = random_board_pose(camera, board, random);
    images.push_back(board_image(camera, board, pose, noise, random.seed()));
  }
  return images;
}

/// A grey image of the board with a white border of one square: 2×2 rays per pixel.
inline std::vector<std::uint8_t> rendered_board(const CameraModel& camera, const Board& board,
                                                const Eigen::Isometry3d& T_camera_board) {
  const CameraIntrinsics& K = camera.intrinsics;
  const Eigen::Isometry3d T_board_camera = T_camera_board.inverse();
  const auto brightness = [&](double u, double v) {
    const Eigen::Vector2d shown = K.ray(u, v).head<2>();
    const std::optional<Eigen::Vector2d> ray =
        camera.distortion.is_none() ? std::optional(shown) : camera.distortion.undistorted(shown);
    if (!ray) return 90.0;
    const Eigen::Vector3d direction = T_board_camera.linear() * ray->homogeneous();
    const Eigen::Vector3d p = T_board_camera.translation() -
                              direction * (T_board_camera.translation().z() / direction.z());
    const double x = std::floor(p.x() / board.square), y = std::floor(p.y() / board.square);
    if (x < -2 || y < -2 || x > board.columns || y > board.rows) return 90.0;
    if (x < -1 || y < -1 || x > board.columns - 1 || y > board.rows - 1) return 230.0;
    return std::fmod(x + y + 2.0, 2.0) == 0.0 ? 30.0 : 230.0;
  };
  std::vector<std::uint8_t> grey(K.pixels());
  for (Index v = 0; v < K.height; ++v) {
    for (Index u = 0; u < K.width; ++u) {
      double sum = 0.0;
      for (int k = 0; k < 4; ++k)
        sum += brightness(u + (k % 2) / 2.0 - 0.25, v + (k / 2) / 2.0 - 0.25);
      grey[std::size_t{v} * K.width + u] = static_cast<std::uint8_t>(sum / 4.0);
    }
  }
  return grey;
}

}  // namespace symscene::calibration_test
