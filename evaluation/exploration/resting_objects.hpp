#pragma once

#include <functional>
#include <vector>

#include "symscene/clutter/clutter_world.hpp"
#include "symscene/clutter/table_world.hpp"
#include "symscene/ground_truth/scene_truth.hpp"

namespace symscene {

/// Objects at rest on the table of the clutter benchmark, in its world frame.
struct RestingObjects {
  std::vector<TriangleMesh> surfaces;
  SceneTruth truth;                 ///< their symmetries, without masks
  std::vector<std::size_t> bodies;  ///< per object its number in the outcome of a grasp
  /// Executes a grasp and puts all objects back to where they were, at rest. T_world_tool.
  std::function<GraspOutcome(const Eigen::Isometry3d&, const GraspExecutionOptions&)> rehearse;
};

/// Those that are present in the world, which must outlive them.
RestingObjects resting_objects(ClutterWorld& world);
RestingObjects resting_objects(TableWorld& world);

}  // namespace symscene
