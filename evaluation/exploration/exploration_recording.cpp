#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/looking_at.hpp"
#include "exploration_world.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/object_class.hpp"
#include "symscene/exploration/exploration_output.hpp"
#include "symscene/view_planning/view_candidates.hpp"

namespace symscene {
namespace {

constexpr double rest = 1.2;          // of the camera at a view [s]
constexpr double travel = 0.8;        // between two views [s]
constexpr int moments = 8;            // recorded per motion
constexpr std::size_t coarser = 4;    // pixels of a depth image per shown one, along each axis
constexpr std::size_t listed = 12;    // candidates that the page draws after each view
constexpr double camera_size = 0.05;  // of the pyramid that shows the camera [m]

double time_of(std::size_t view) { return static_cast<double>(view) * (rest + travel); }

/// A pyramid from the camera's centre to its image.
TriangleMesh camera_mesh(const CameraIntrinsics& camera) {
  const Eigen::Vector2d half = camera.half_size();
  TriangleMesh mesh;
  mesh.vertices.resize(5, 3);
  mesh.vertices.row(0).setZero();
  for (int k = 0; k < 4; ++k) {
    const double x = k == 1 || k == 2 ? half.x() : -half.x();
    const double y = k >= 2 ? half.y() : -half.y();
    mesh.vertices.row(k + 1) = (camera_size * Eigen::RowVector3d(x, y, 1.0)).cast<float>();
  }
  mesh.triangles.resize(6, 3);
  mesh.triangles << 0, 2, 1, 0, 3, 2, 0, 4, 3, 0, 1, 4, 1, 2, 3, 1, 3, 4;
  return mesh;
}

/// A square on the table around its middle, in the table's frame.
TriangleMesh middle_of_table() {
  constexpr float half = 0.35F;  // [m]
  TriangleMesh mesh;
  mesh.vertices.resize(4, 3);
  mesh.vertices << -half, -half, 0.0F, half, -half, 0.0F, half, half, 0.0F, -half, half, 0.0F;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 0, 2, 3;
  return mesh;
}

std::vector<RecordedSolid> solids_of(const CameraIntrinsics& camera, const Tabletop& table) {
  std::vector<RecordedSolid> solids;
  for (const PlacedObject& placed : table.objects)
    solids.push_back({placed.object.name, placed.object.mesh, RecordedKind::object});
  solids.push_back({"table", middle_of_table(), RecordedKind::table});
  solids.push_back({"camera", camera_mesh(camera), RecordedKind::hand});
  return solids;
}

/// A pose on the way from one candidate to another, around the objects.
Eigen::Isometry3d between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to,
                          double share) {
  const Eigen::Vector3d target = exploration_target();
  const Eigen::Vector3d a = from.translation() - target, b = to.translation() - target;
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond::Identity().slerp(share, Eigen::Quaterniond(shortest_rotation(a, b)));
  const double radius = (1.0 - share) * a.norm() + share * b.norm();
  return looking_at(target + radius * (turn * a).normalized(), target);
}

/// Adds a moment in which all rests but the camera.
void add_moment(double time, const Eigen::Isometry3d& T_world_camera, const Tabletop& table,
                RunRecording& run) {
  const Eigen::Isometry3d T_table_world = table.T_world_table.inverse();
  std::vector<Eigen::Isometry3d> poses;
  for (const PlacedObject& placed : table.objects)
    poses.push_back(T_table_world * placed.T_world_object);
  poses.push_back(Eigen::Isometry3d::Identity());
  poses.push_back(T_table_world * T_world_camera);
  run.times.push_back(time);
  run.poses.push_back(std::move(poses));
}

void add_moments(const std::vector<ExploredView>& views, const Tabletop& table, RunRecording& run) {
  for (std::size_t k = 0; k < views.size(); ++k) {
    const Eigen::Isometry3d& pose = views[k].T_world_camera;
    add_moment(time_of(k), pose, table, run);
    add_moment(time_of(k) + rest, pose, table, run);
    for (int m = 1; m < moments && k + 1 < views.size(); ++m) {
      const double share = static_cast<double>(m) / moments;
      add_moment(time_of(k) + rest + travel * share,
                 between(pose, views[k + 1].T_world_camera, share), table, run);
    }
  }
}

/// The closed surface in the table's frame: light where it was observed, dark where it is inferred.
TriangleMesh shaded(const ObjectSurface& surface, const Eigen::Isometry3d& T_table_world) {
  TriangleMesh mesh = surface.mesh;
  const Eigen::Isometry3f T = T_table_world.cast<float>();
  mesh.vertices =
      (surface.mesh.vertices * T.linear().transpose()).rowwise() + T.translation().transpose();
  mesh.normals.resize(0, 3);
  mesh.colors.resize(mesh.vertices.rows(), 3);
  mesh.colors.setConstant(40);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    if (surface.observed[static_cast<std::size_t>(t)] == 0) continue;
    for (int corner = 0; corner < 3; ++corner)
      mesh.colors.row(mesh.triangles(t, corner)).setConstant(245);
  }
  return mesh;
}

std::string label_of(const SceneObject& object, std::size_t number) {
  const bool is_named = object.symmetry_class && object.symmetry_class->kind != SymmetryClass::none;
  return fmt::format("{} {}, {:.2f}", is_named ? to_string(object.symmetry_class->kind) : "object",
                     number, object.rank());
}

RecordedBelief belief_of(const ExploredView& view, double time,
                         const Eigen::Isometry3d& T_table_world) {
  RecordedBelief belief;
  belief.time = time;
  for (std::size_t k = 0; k < view.objects.size(); ++k) {
    const bool has_surface = k < view.surfaces.size();
    belief.objects.push_back(
        {fmt::format("object {}", k),
         has_surface ? shaded(view.surfaces[k], T_table_world) : TriangleMesh{},
         label_of(view.objects[k], k)});
  }
  return belief;
}

/// Views as the page draws them.
class ShownViews {
 public:
  ShownViews(const TableExploration& exploration, const Eigen::Isometry3d& T_table_world)
      : exploration_(exploration), T_table_world_(T_table_world) {}

  PageView view(const RankedView& ranked) const {
    const auto shown = [&](double gain) { return shown_gain(gain, exploration_.policy); };
    const ViewGain& gain = ranked.gain;
    return {ranked.candidate,
            T_table_world_ * exploration_.candidates[ranked.candidate],
            shown(gain.total()),
            shown(gain.inferred),
            shown(gain.disputed),
            shown(gain.unknown),
            0.0};
  }

  PageViews best(const NextViews& next) const {
    const Eigen::Vector2d half = exploration_.camera.half_size();
    PageViews page;
    page.policy = to_string(exploration_.policy);
    page.unit = gain_unit(exploration_.policy);
    page.half_width = half.x();
    page.half_height = half.y();
    page.is_enough = next.is_enough;
    for (std::size_t k = 0; k < std::min(listed, next.ranked.size()); ++k)
      page.views.push_back(view(next.ranked[k]));
    return page;
  }

 private:
  const TableExploration& exploration_;
  Eigen::Isometry3d T_table_world_;
};

}  // namespace

ExplorationRecording exploration_recording(const TableExploration& exploration,
                                           const Tabletop& table) {
  ExplorationRecording recording;
  RunRecording& run = recording.run;
  const Eigen::Isometry3d T_table_world = table.T_world_table.inverse();
  const ShownViews shown(exploration, T_table_world);
  run.solids = solids_of(exploration.camera, table);
  add_moments(exploration.views, table, run);
  for (std::size_t k = 0; k < exploration.views.size(); ++k) {
    const ExploredView& view = exploration.views[k];
    const double time = time_of(k);
    run.beliefs.push_back(belief_of(view, time, T_table_world));
    run.events.push_back({time, format_explored_view(view, k + 1, exploration.policy)});
    recording.views.push_back(
        {time, shown.view({view.step.view, view.step.gain.value_or(ViewGain{})}),
         view.step.observed, view.step.completed, view.objects.size(), shown.best(view.next),
         shown_depth(view.depth, exploration.camera, coarser)});
  }
  recording.end = description(exploration.end);
  run.events.push_back({run.times.back(), recording.end, RecordedOutcome::success});
  run.left = format_left_unknown(exploration, table);
  return recording;
}

}  // namespace symscene
