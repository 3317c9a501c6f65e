#include "symscene/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "symscene/core/error.hpp"
#include "symscene/core/parallel.hpp"
#include "symscene/simulation/depth_renderer.hpp"
#include "symscene/simulation/shapes.hpp"

namespace symscene {
namespace {

constexpr double table_size = 2.4;        // [m]
constexpr double table_thickness = 0.03;  // [m]

/// A camera at `eye` that looks at `target` with the table's up in its image.
Eigen::Isometry3d looking_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  const Eigen::Vector3d forward = (target - eye).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << right, forward.cross(right), forward;
  pose.translation() = eye;
  return pose;
}

/// Along the arc the camera rises from its lowest to its highest elevation and comes back, as a
/// hand would.
Eigen::Isometry3d arc_pose(const CameraArcOptions& options, int frame) {
  const double t = options.frames > 1 ? static_cast<double>(frame) / (options.frames - 1) : 0.5;
  const double heading = options.arc * (t - 0.5);
  const double elevation = options.min_elevation + (options.max_elevation - options.min_elevation) *
                                                       std::sin(std::numbers::pi * t);
  const Eigen::Vector3d target(0, 0, options.target_height);
  const Eigen::Vector3d back(std::cos(elevation) * std::cos(heading),
                             std::cos(elevation) * std::sin(heading), std::sin(elevation));
  return looking_at(target + options.radius * back, target);
}

TriangleMesh table_mesh(const Tabletop& tabletop) {
  Eigen::Isometry3d below = tabletop.T_world_table;
  below.translate(Eigen::Vector3d(0, 0, -table_thickness));
  TriangleMesh mesh =
      transformed(make_box({table_size, table_size, table_thickness}, table_size), below);
  mesh.colors = Colors::Constant(mesh.vertices.rows(), 3, 170);
  return mesh;
}

/// The box around all objects, standing on the table.
OrientedBox object_box(const Tabletop& tabletop) {
  const Eigen::Isometry3d T_table_world = tabletop.T_world_table.inverse();
  OrientedBox box;
  box.T_world_box = tabletop.T_world_table;
  box.min.setConstant(std::numeric_limits<double>::infinity());
  box.max = -box.min;
  for (const PlacedObject& placed : tabletop.objects) {
    const TriangleMesh mesh =
        transformed(placed.object.mesh, T_table_world * placed.T_world_object);
    box.min = box.min.cwiseMin(mesh.vertices.colwise().minCoeff().transpose().cast<double>());
    box.max = box.max.cwiseMax(mesh.vertices.colwise().maxCoeff().transpose().cast<double>());
  }
  box.min.z() = 0.0;
  return box;
}

OrientedBox padded(OrientedBox box, double sides, double below) {
  box.min.array() -= sides;
  box.max.array() += sides;
  box.min.z() = -below;
  return box;
}

/// Points that are left after thinning to 5 mm.
std::size_t thinned_size(const Points& points, const PointIndices& indices) {
  constexpr float edge = 0.005F;
  std::set<std::array<int, 3>> cells;
  for (const Index i : indices) {
    const auto cell = [&](int axis) {
      return static_cast<int>(std::floor(points(i, axis) / edge));
    };
    cells.insert({cell(0), cell(1), cell(2)});
  }
  return cells.size();
}

void add_truth(const Tabletop& tabletop, const FusedCloud& fused, int min_points,
               SimulatedScene& result) {
  std::vector<PointIndices> masks(tabletop.objects.size());
  for (Index i = 0; i < fused.objects.size(); ++i) {
    if (fused.objects[i] < masks.size()) masks[fused.objects[i]].push_back(i);
  }
  result.truth.table = tabletop.plane();
  for (Index k = 0; k < masks.size(); ++k) {
    if (thinned_size(fused.cloud.positions, masks[k]) < static_cast<std::size_t>(min_points)) {
      continue;
    }
    TrueObject object = true_object(tabletop.objects[k]);
    object.points = std::move(masks[k]);
    result.truth.objects.push_back(std::move(object));
    result.sources.push_back(k);
  }
}

}  // namespace

void CameraArcOptions::validate() const {
  require_option(frames >= 1 && frames <= 64, "frames", "1 to 64", frames);
  require_option(arc >= 0, "arc", "an angle not below zero", arc);
  require_option(radius > 0, "radius", "a positive number", radius);
  require_option(min_elevation > 0, "min_elevation", "a positive angle", min_elevation);
  require_option(max_elevation >= min_elevation && max_elevation < radians(89), "max_elevation",
                 "at least min_elevation and below 89 degrees", max_elevation);
  require_option(width >= 16, "width", "at least 16 px", width);
  require_option(height >= 16, "height", "at least 16 px", height);
  require_option(focal_length > 0, "focal_length", "a positive number", focal_length);
}

CameraIntrinsics CameraArcOptions::intrinsics() const {
  return {static_cast<Index>(width), static_cast<Index>(height), focal_length, focal_length,
          0.5 * (width - 1),         0.5 * (height - 1)};
}

void SimulationOptions::validate() const {
  tabletop.validate();
  camera.validate();
  sensor.validate();
  cloud.validate();
  occupancy.validate();
  require_option(margin >= 0, "margin", "a number not below zero", margin);
  require_option(table_clearance >= 0, "table_clearance", "a number not below zero",
                 table_clearance);
  require_option(min_object_points >= 1, "min_object_points", "at least 1", min_object_points);
}

std::vector<SensorFrame> capture_frames(const Tabletop& tabletop,
                                        const SimulationOptions& options) {
  options.validate();
  std::vector<TriangleMesh> meshes;
  for (const PlacedObject& placed : tabletop.objects) meshes.push_back(world_mesh(placed));
  meshes.push_back(table_mesh(tabletop));
  const DepthRenderer renderer(meshes);
  const CameraIntrinsics camera = options.camera.intrinsics();
  std::vector<SensorFrame> frames(static_cast<std::size_t>(options.camera.frames));
  parallel_for_each(frames.size(), [&](std::size_t i) {
    const Eigen::Isometry3d pose =
        tabletop.T_world_table * arc_pose(options.camera, static_cast<int>(i));
    // Streams 0 and 1 of the seed arrange the tabletop.
    frames[i] = add_sensor_noise(renderer.render(camera, pose), camera, options.sensor,
                                 Random(options.tabletop.seed, i + 2));
  });
  return frames;
}

SimulatedScene fuse_frames(const Tabletop& tabletop, std::span<const SensorFrame> frames,
                           const SimulationOptions& options) {
  options.validate();
  const CameraIntrinsics camera = options.camera.intrinsics();
  const OrientedBox objects = object_box(tabletop);
  FusedCloud fused =
      fuse_cloud(frames, camera, padded(objects, 0.02, -options.table_clearance), options.cloud);
  SimulatedScene result;
  add_truth(tabletop, fused, options.min_object_points, result);
  result.scene.cloud = std::move(fused.cloud);
  result.scene.occupancy = fuse_occupancy(
      frames, camera, padded(objects, options.margin, table_thickness), options.occupancy);
  result.scene.table = tabletop.plane();
  result.tabletop = tabletop;
  return result;
}

SimulatedScene simulate_tabletop(const SimulationOptions& options) {
  options.validate();
  const Tabletop tabletop = arrange_tabletop(options.tabletop);
  return fuse_frames(tabletop, capture_frames(tabletop, options), options);
}

}  // namespace symscene
