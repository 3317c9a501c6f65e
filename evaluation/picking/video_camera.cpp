#include "video_camera.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/looking_at.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/types.hpp"

namespace symscene {
namespace {

constexpr double elevation = radians(28.0);  // of the camera, seen from the scene
constexpr double azimuth = radians(40.0);    // off the direction in which the robot looks
constexpr double half_field = radians(20.0);
constexpr double margin = 1.05;

using Corners = std::vector<Eigen::Vector3d>;

void add_corners(const RecordedSolid& solid, const Eigen::Isometry3d& pose, Corners& corners) {
  const auto box = bounding_box(solid.mesh.vertices);
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3f corner((k & 1) != 0 ? box.max.x() : box.min.x(),
                                 (k & 2) != 0 ? box.max.y() : box.min.y(),
                                 (k & 4) != 0 ? box.max.z() : box.min.z());
    corners.push_back(pose * corner.cast<double>());
  }
}

Corners corners_to_see(const RunRecording& recording) {
  Corners corners;
  for (std::size_t k = 0; k < recording.solids.size(); ++k) {
    const RecordedSolid& solid = recording.solids[k];
    if (solid.kind == RecordedKind::object || solid.mesh.vertices.rows() == 0) continue;
    for (const std::vector<Eigen::Isometry3d>& poses : recording.poses)
      add_corners(solid, poses[k], corners);
  }
  if (corners.empty()) corners.emplace_back(Eigen::Vector3d::Zero());
  return corners;
}

/// Where the robot stands as seen from the table; it looks the other way. Behind it is -x if there
/// is no robot.
Eigen::Vector3d robot_side(const RunRecording& recording) {
  Corners corners;
  for (std::size_t k = 0; k < recording.solids.size(); ++k) {
    const RecordedSolid& solid = recording.solids[k];
    if (solid.kind == RecordedKind::robot && solid.mesh.vertices.rows() > 0)
      add_corners(solid, recording.poses.front()[k], corners);
  }
  Eigen::Vector3d side = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : corners) side += corner;
  side.z() = 0.0;
  return side.norm() > 1e-6 ? side.normalized() : Eigen::Vector3d(-Eigen::Vector3d::UnitX());
}

/// Columns: right, down and forward of the image.
Eigen::Matrix3d orientation(const RunRecording& recording) {
  const Eigen::Vector3d level =
      Eigen::AngleAxisd(azimuth, Eigen::Vector3d::UnitZ()) * robot_side(recording);
  const Eigen::Vector3d forward =
      std::cos(elevation) * level - std::sin(elevation) * Eigen::Vector3d::UnitZ();
  return looking_at(Eigen::Vector3d::Zero(), forward).linear();
}

/// The pose of the nearest camera with this orientation that sees all corners.
Eigen::Isometry3d nearest_pose(const Eigen::Matrix3d& R, const Corners& corners,
                               const Eigen::Array2d& half_width) {
  Eigen::AlignedBox3d box;  // in the axes of the camera
  for (const Eigen::Vector3d& corner : corners) box.extend(R.transpose() * corner);
  const Eigen::Vector3d center = box.center();
  double distance = 0.1;
  for (const Eigen::Vector3d& corner : corners) {
    const Eigen::Vector3d p = R.transpose() * corner - center;
    distance = std::max(distance, (p.head<2>().array().abs() / half_width).maxCoeff() - p.z());
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = R;
  pose.translation() = R * (center - distance * Eigen::Vector3d::UnitZ());
  return pose;
}

}  // namespace

VideoCamera video_camera(const RunRecording& recording, const RunVideoOptions& options) {
  const Eigen::Array2d size(options.width, options.height);
  const double focal_length = 0.5 * size.minCoeff() / std::tan(half_field);
  CameraIntrinsics intrinsics{static_cast<Index>(options.width),
                              static_cast<Index>(options.height),
                              focal_length,
                              focal_length,
                              0.5 * (size.x() - 1.0),
                              0.5 * (size.y() - 1.0)};
  const Eigen::Array2d half_width = 0.5 * size / focal_length / margin;
  return {intrinsics, nearest_pose(orientation(recording), corners_to_see(recording), half_width)};
}

}  // namespace symscene
