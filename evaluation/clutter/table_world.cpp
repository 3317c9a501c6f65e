#include "symscene/clutter/table_world.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/solid.hpp"

namespace symscene {
namespace {

constexpr double resting_speed = 0.01;  // [m/s], as in the clutter-removal benchmark
constexpr double rest_interval = 0.25;  // simulated between two checks for rest [s]
constexpr double longest_rest = 2.0;    // simulated [s]

double mass_of(const ObjectModel& model, double density) {
  const double volume = solid_properties(model.mesh).volume;
  if (!(volume > 0.0))
    throw InputError(model.name, "a closed mesh with its outside counter-clockwise", "no volume");
  return density * volume;
}

}  // namespace

TableWorld::TableWorld(const Tabletop& tabletop, const DropOptions& drop,
                       const GraspWorldOptions& physics)
    : tabletop_(tabletop), area_(drop.area), T_table_world_(tabletop.T_world_table.inverse()) {
  const std::vector<PlacedObject>& objects = tabletop_.objects;
  parts_.resize(objects.size());
  parallel_for_each(objects.size(), [&](std::size_t i) {
    parts_[i] = convex_parts(objects[i].object.mesh, drop.parts);
  });
  std::vector<WeighedBody> bodies;
  for (std::size_t i = 0; i < objects.size(); ++i)
    bodies.push_back({&parts_[i], mass_of(objects[i].object, drop.physics.density)});
  world_.emplace(bodies, panda_parallel_hand(), std::span<const FixedBox>(), physics);
  for (std::size_t i = 0; i < objects.size(); ++i)
    world_->put(i, T_table_world_ * objects[i].T_world_object);
  settle();
}

std::vector<std::size_t> TableWorld::present() const {
  std::vector<std::size_t> objects;
  for (std::size_t i = 0; i < tabletop_.objects.size(); ++i) {
    if (world_->is_there(i)) objects.push_back(i);
  }
  return objects;
}

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
  world_->put_hand(T_table_world_ * T_world_tool);
  const HandContacts contacts = world_->hand_contacts();
  world_->take_hand_away();
  double depth = contacts.table_depth;
  for (std::size_t k = 0; k < contacts.bodies.size(); ++k) {
    if (contacts.bodies[k] != aimed) depth = std::max(depth, contacts.depths[k]);
  }
  return depth;
}

GraspOutcome TableWorld::executed(const Eigen::Isometry3d& T_world_tool,
                                  const GraspExecutionOptions& options) {
  const GraspOutcome outcome = execute_grasp(*world_, T_table_world_ * T_world_tool, options);
  world_->take_hand_away();
  return outcome;
}

GraspOutcome TableWorld::rehearse(const Eigen::Isometry3d& T_world_tool,
                                  const GraspExecutionOptions& options) {
  const std::vector<std::size_t> objects = present();
  std::vector<Eigen::Isometry3d> poses;
  for (const std::size_t i : objects) poses.push_back(world_->pose(i));
  const GraspOutcome outcome = executed(T_world_tool, options);
  for (std::size_t k = 0; k < objects.size(); ++k) world_->put(objects[k], poses[k]);
  return outcome;
}

GraspOutcome TableWorld::execute(const Eigen::Isometry3d& T_world_tool,
                                 const GraspExecutionOptions& options) {
  const GraspOutcome outcome = executed(T_world_tool, options);
  if (outcome.end == GraspEnd::success) world_->take_away(*outcome.body);
  settle();
  return outcome;
}

bool TableWorld::at_rest() const {
  const std::vector<std::size_t> objects = present();
  return std::all_of(objects.begin(), objects.end(),
                     [&](std::size_t i) { return world_->speed(i) <= resting_speed; });
}

void TableWorld::advance_to_rest() {
  double seconds = 0.0;
  do {
    world_->advance(rest_interval);
    seconds += rest_interval;
  } while (!at_rest() && seconds < longest_rest);
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
