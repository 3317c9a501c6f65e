#include "symscene/simulation/simulation.hpp"

#include <limits>

#include "core/parallel.hpp"
#include "core/random.hpp"
#include "core/thinned_size.hpp"
#include "simulation/depth_renderer.hpp"
#include "simulation/frame_fusion.hpp"
#include "simulation/shapes.hpp"
#include "simulation/tabletop_meshes.hpp"
#include "symscene/core/error.hpp"
#include "tabletop_parts.hpp"

namespace symscene {
namespace {

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

void SimulationOptions::validate() const {
  check_fields(*this);
  require_option(camera.frames <= 64, "frames", "1 to 64", camera.frames);
}

std::vector<SensorFrame> capture_frames(const Tabletop& tabletop,
                                        const SimulationOptions& options) {
  options.validate();
  const DepthRenderer renderer(tabletop_meshes(tabletop));
  const CameraIntrinsics camera = options.camera.intrinsics();
  const std::vector<Eigen::Isometry3d> poses = camera_arc(options.camera);
  std::vector<SensorFrame> frames(poses.size());
  parallel_for_each(frames.size(), [&](std::size_t i) {
    const Eigen::Isometry3d pose = tabletop.T_world_table * poses[i];
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
