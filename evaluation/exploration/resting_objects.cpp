#include "resting_objects.hpp"

#include "true_symmetries.hpp"

namespace symscene {
namespace {

Plane benchmark_table() { return {Eigen::Vector3d::UnitZ(), -clutter::table_height}; }

template <class World>
RestingObjects present_in(World& world) {
  RestingObjects resting;
  resting.truth.table = benchmark_table();
  resting.bodies = world.present();
  resting.rehearse = [&world](const Eigen::Isometry3d& T_world_tool,
                              const GraspExecutionOptions& options) {
    return world.rehearse(T_world_tool, options);
  };
  return resting;
}

}  // namespace

RestingObjects resting_objects(ClutterWorld& world) {
  RestingObjects resting = present_in(world);
  resting.surfaces = world.surfaces();
  for (const std::size_t item : resting.bodies) {
    const ClutterObject& object = world.object(item);
    resting.truth.objects.push_back(placed(true_symmetries(object.name, object.surface),
                                           world.items()[item].scale, world.pose(item)));
  }
  return resting;
}

RestingObjects resting_objects(TableWorld& world) {
  RestingObjects resting = present_in(world);
  for (const PlacedObject& own : world.tabletop().objects) {
    resting.surfaces.push_back(world_mesh(own));
    resting.truth.objects.push_back(
        placed(true_symmetries(own.object.name, own.object.mesh), 1.0, own.T_world_object));
  }
  return resting;
}

}  // namespace symscene
