#include "calibrated_cameras.hpp"

#include <cmath>

#include <Eigen/Cholesky>

#include "calibration/simulated_boards.hpp"
#include "core/rigid_motion.hpp"
#include "simulation/erring_camera.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/frame_rectifier.hpp"
#include "symscene/simulation/sensor_noise.hpp"

namespace symscene::bench {
namespace {

using namespace calibration_test;

/// The camera as its driver describes the lens, for boards, whose corners have no depth.
CameraModel lens_of(const CameraToCalibrate& camera) {
  return {camera.intrinsics, camera.errors.lens(), std::nullopt, std::nullopt};
}

/// The pose of a wall, whose face is z = 0, in the frame of the camera.
Eigen::Isometry3d wall_pose(double distance, double about_x, double about_y) {
  Eigen::Isometry3d pose(Eigen::AngleAxisd(about_x, Eigen::Vector3d::UnitX()) *
                         Eigen::AngleAxisd(about_y, Eigen::Vector3d::UnitY()));
  pose.translation().z() = distance;
  return pose;
}

SensorFrame seen_wall(const ErringCamera& camera, const Eigen::Isometry3d& T_camera_wall) {
  const TriangleMesh mesh = transformed(make_box({8.0, 8.0, 0.05}, 1.0), T_camera_wall);
  const DepthRenderer renderer(std::span(&mesh, 1));
  return camera.render(renderer, Eigen::Isometry3d::Identity());
}

Plane plane_of(const Eigen::Isometry3d& T_camera_wall) {
  const Eigen::Vector3d normal = -T_camera_wall.linear().col(2);
  return {normal, -normal.dot(T_camera_wall.translation())};
}

/// The plane by the corners of a board in the middle of the wall.
std::optional<Plane> measured_plane(const CameraToCalibrate& camera, const CameraModel& calibrated,
                                    const Eigen::Isometry3d& T_camera_wall, std::uint64_t seed) {
  const Board board{8, 6, 0.06};
  Eigen::Isometry3d T_camera_board = T_camera_wall;
  T_camera_board.translate(-0.5 * board.corner(board.corners() - 1));
  const BoardImage image = board_image(lens_of(camera), board, T_camera_board, 0.1, seed);
  const auto pose = board_pose(image, calibrated, board);
  if (!pose) return std::nullopt;
  return plane_of(*pose);
}

/// Means over blocks of 16×16 pixels of depth, over true depth, and the rays through their centres.
/// They leave out what the nearest pixel is off: half a pixel along a slope.
struct BlockMean {
  Eigen::Vector3d ray;
  double inverse = 0.0;  ///< of the depth [1/m]
};

std::vector<BlockMean> block_means(const DepthFrame& frame, const CameraIntrinsics& camera) {
  constexpr Index edge = 16;
  std::vector<BlockMean> means;
  for (Index j = 0; j + edge <= camera.height; j += edge) {
    for (Index i = 0; i + edge <= camera.width; i += edge) {
      double sum = 0.0;
      bool is_whole = true;
      for (Index v = j; v < j + edge; ++v) {
        for (Index u = i; u < i + edge; ++u) {
          const double z = frame.depth[std::size_t{v} * camera.width + u];
          is_whole = is_whole && z > 0.0;
          sum += 1.0 / z;
        }
      }
      constexpr double middle = (edge - 1) / 2.0;
      if (is_whole) means.push_back({camera.ray(i + middle, j + middle), sum / (edge * edge)});
    }
  }
  return means;
}

}  // namespace

CameraToCalibrate simulated_camera(double bias, std::uint64_t pattern) {
  CameraToCalibrate camera{{640, 480, 525.0, 525.0, 319.5, 239.5}, {}};
  camera.errors.k1 = -0.12;
  camera.errors.k2 = 0.06;
  camera.errors.p1 = 0.001;
  camera.errors.p2 = -0.0015;
  camera.errors.depth_bias = bias;
  camera.errors.bias_pattern = pattern;
  return camera;
}

IntrinsicCalibration found_intrinsics(const CameraToCalibrate& camera, int images, double noise,
                                      std::uint64_t seed) {
  const auto boards = board_images(lens_of(camera), the_board(), images, noise, seed);
  return calibrate_intrinsics(boards, camera.intrinsics.width, camera.intrinsics.height,
                              the_board());
}

DepthCalibration found_depth(const CameraToCalibrate& camera, const CameraModel& calibrated,
                             int views, bool has_board, std::uint64_t seed) {
  CameraModel lens = calibrated;
  lens.depth_correction.reset();
  const FrameRectifier rectifier(lens);
  const ErringCamera erring(camera.intrinsics, camera.errors);
  WallCalibrator calibrator(calibrated.intrinsics);
  Random random(seed);
  for (int i = 0; i < views; ++i) {
    const double distance = 0.5 * std::pow(2.2 / 0.5, i / (views - 1.0));
    const Eigen::Isometry3d pose =
        wall_pose(distance, random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
    const SensorFrame seen = add_sensor_noise(seen_wall(erring, pose), camera.intrinsics, {},
                                              Random(seed, static_cast<std::uint64_t>(i) + 1));
    const DepthFrame frame = rectifier.rectified(DepthFrame{0.0, seen.depth, {}});
    const auto plane = measured_plane(camera, calibrated, pose, random.seed());
    calibrator.add(frame.depth, has_board ? plane : std::nullopt);
  }
  return calibrator.calibrate();
}

WallErrors wall_errors(const CameraToCalibrate& camera, const CameraModel& calibrated,
                       double distance) {
  const FrameRectifier rectifier(calibrated);
  const ErringCamera erring(camera.intrinsics, camera.errors);
  double squares = 0.0, warp = 0.0;
  std::size_t count = 0;
  for (const auto& [about_x, about_y] : {std::pair(0.0, 0.0), std::pair(0.3, -0.2)}) {
    const Eigen::Isometry3d pose = wall_pose(distance, about_x, about_y);
    const DepthFrame frame =
        rectifier.rectified(DepthFrame{0.0, seen_wall(erring, pose).depth, {}});
    const Plane plane = plane_of(pose);
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    const std::vector<BlockMean> means = block_means(frame, calibrated.intrinsics);
    for (const auto& [ray, inverse] : means) {
      const double error = -plane.offset / plane.normal.dot(ray) * inverse - 1.0;
      squares += error * error;
      A += ray * ray.transpose(), b += ray * inverse;
    }
    const Eigen::Vector3d fit = A.ldlt().solve(b);
    for (const auto& [ray, inverse] : means) warp += std::pow(fit.dot(ray) / inverse - 1.0, 2.0);
    count += means.size();
  }
  const auto n = static_cast<double>(count);
  return {std::sqrt(squares / n), std::sqrt(warp / n)};
}

}  // namespace symscene::bench
