#include "symscene/clutter/table_look.hpp"

#include <optional>

#include "stopwatch.hpp"

namespace symscene {
TableLook look_at_table(const Tabletop& tabletop, const SweepOptions& sweep,
                        const TableLookOptions& options) {
  options.validate();
  TableLook look;
  Reconstruction reconstruction(sweep.camera.intrinsics(), options.reconstruction);
  Trajectory tracked;
  std::vector<Eigen::Isometry3d> estimated, truth;
  std::optional<Eigen::Isometry3d> T_first_world;
  capture_sweep(tabletop, sweep, [&](const DepthFrame& frame, const Eigen::Isometry3d& pose) {
    if (!T_first_world) T_first_world = pose.inverse();
    std::optional<Eigen::Isometry3d> known;
    if (options.exact_poses) known = *T_first_world * pose;
    const Stopwatch watch;
    const FrameReport report = reconstruction.add(frame, known);
    look.seconds += watch.seconds();
    ++look.frames;
    if (!report.fused) return;
    tracked.push_back({frame.time, report.tracking.T_world_camera});
    estimated.push_back(report.tracking.T_world_camera);
    truth.push_back(pose);
  });
  look.fused = estimated.size();
  if (look.fused == 0) return look;
  look.trajectory = trajectory_error(estimated, truth);
  look.T_world_scene = truth.front() * estimated.front().inverse();
  const Stopwatch watch;
  const TriangleMesh surface = reconstruction.surface();
  if (surface.vertices.rows() != 0) {
    look.scene = build_scene({surface.vertices, surface.normals, surface.colors},
                             reconstruction.occupancy(), prior_of(tracked), options.scene)
                     .scene;
    // Without a table, what was seen is not what stands on it.
    if (!look.scene.table) look.scene = {};
  }
  look.seconds += watch.seconds();
  return look;
}

}  // namespace symscene
