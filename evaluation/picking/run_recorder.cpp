#include "run_recorder.hpp"

#include <fmt/format.h>

#include "robots/solid_mesh.hpp"

namespace symscene {
namespace {

TriangleMesh table_mesh(const TableOptions& table) {
  constexpr double thickness = 0.03;
  const Eigen::Vector3d half(0.5 * table.length, 0.5 * table.width, 0.0);
  return box_mesh({Eigen::Vector3d(-half - thickness * Eigen::Vector3d::UnitZ()), half});
}

}  // namespace

RunRecorder::RunRecorder(const PickTable& table, const RobotSolids& robot, const TriangleMesh& bin,
                         double rate, const PickObserver& observer)
    : robot_(robot), observer_(observer), interval_(1.0 / rate) {
  for (const RobotSolid& solid : robot.solids())
    recording_.solids.push_back(
        {solid.name, solid.mesh, solid.is_hand ? RecordedKind::hand : RecordedKind::robot});
  recording_.solids.push_back({"bin", bin, RecordedKind::bin});
  recording_.solids.push_back({"table", table_mesh(table.tabletop.table), RecordedKind::table});
  for (const PlacedObject& placed : table.tabletop.objects)
    recording_.solids.push_back({placed.object.name, placed.object.mesh, RecordedKind::object});
}

void RunRecorder::step(const ArmCell& cell) {
  if (cell.time() < next_) return;
  next_ += interval_;
  std::vector<Eigen::Isometry3d> poses = robot_.poses(cell.state());
  for (int fixed = 0; fixed < 2; ++fixed) poses.push_back(Eigen::Isometry3d::Identity());
  for (std::size_t i = 0; i < cell.objects(); ++i) poses.push_back(cell.pose(i));
  recording_.times.push_back(cell.time());
  recording_.poses.push_back(std::move(poses));
}

void RunRecorder::add(const TableBelief& belief, double time) {
  RecordedBelief recorded{time, {}};
  for (std::size_t k = 0; k < belief.scene.objects.size(); ++k)
    recorded.objects.push_back(
        {fmt::format("object {}", k), belief.scene.objects[k].surface.mesh, belief.labels[k]});
  recording_.beliefs.push_back(std::move(recorded));
}

void RunRecorder::add(double time, const std::string& text, RecordedOutcome outcome) {
  recording_.events.push_back({time, text, outcome});
  if (observer_.on_event) observer_.on_event(recording_.events.back());
}

}  // namespace symscene
