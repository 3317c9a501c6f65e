#include "symscene/clutter/table_world.hpp"

#include <algorithm>

#include "clutter/object_bodies.hpp"
#include "symscene/clutter/grasp_trials.hpp"

namespace symscene {
namespace {

constexpr double rest_interval = 0.25;  // simulated between two checks for rest [s]
constexpr double longest_rest = 2.0;    // simulated [s]

}  // namespace

TableWorld::TableWorld(const Tabletop& tabletop, const DropOptions& drop,
                       const GraspWorldOptions& physics)
    : tabletop_(tabletop), area_(drop.area), T_table_world_(tabletop.T_world_table.inverse()) {
  const std::vector<PlacedObject>& objects = tabletop_.objects;
  const std::vector<ConvexParts> parts = parts_of_objects(objects, drop.parts);
  world_.emplace(bodies_of_objects(objects, parts, drop.physics.density), panda_parallel_hand(),
                 std::span<const FixedBox>(), physics);
  for (std::size_t i = 0; i < objects.size(); ++i)
    world_->put(i, T_table_world_ * objects[i].T_world_object);
  settle();
}

std::vector<std::size_t> TableWorld::present() const { return present_bodies(*world_); }

Tabletop TableWorld::tabletop() const {
  Tabletop now = tabletop_;
  now.objects.clear();
  for (const std::size_t i : present()) {
    now.objects.push_back(tabletop_.objects[i]);
    now.objects.back().T_world_object = tabletop_.T_world_table * world_->pose(i);
  }
  return now;
}

double TableWorld::penetration(const Eigen::Isometry3d& T_world_tool, std::size_t aimed) {
  return hand_penetration(*world_, T_table_world_ * T_world_tool, aimed);
}

GraspOutcome TableWorld::rehearse(const Eigen::Isometry3d& T_world_tool,
                                  const GraspExecutionOptions& options) {
  return execute_and_undo(*world_, T_table_world_ * T_world_tool, options);
}

GraspOutcome TableWorld::execute(const Eigen::Isometry3d& T_world_tool,
                                 const GraspExecutionOptions& options) {
  const GraspOutcome outcome = execute_and_remove(*world_, T_table_world_ * T_world_tool, options);
  settle();
  return outcome;
}

void TableWorld::advance_to_rest() {
  double seconds = 0.0;
  do {
    world_->advance(rest_interval);
    seconds += rest_interval;
  } while (!is_at_rest(*world_) && seconds < longest_rest);
}

bool TableWorld::take_away_fallen() {
  bool any = false;
  for (const std::size_t i : present()) {
    const Box own = bounding_box(model(i).mesh.vertices);
    const Eigen::Vector3d middle =
        world_->pose(i) * (0.5F * (own.min + own.max)).cast<double>().eval();
    if (middle.head<2>().norm() < area_) continue;
    world_->take_away(i);
    any = true;
  }
  return any;
}

void TableWorld::settle() {
  do advance_to_rest();
  while (take_away_fallen());
}

}  // namespace symscene
