#pragma once

#include <vector>

#include "symscene/core/grasp.hpp"
#include "symscene/core/gripper.hpp"
#include "symscene/grasping/grasp_options.hpp"

namespace symscene {

/// Grasps of an object, both parts in descending order of quality.
struct DistinctGrasps {
  std::vector<Grasp> kept;
  std::vector<Grasp> outranked;  ///< a better one is near, or there are enough of them
};

/// The best grasps that differ from each other, at most `max_grasps`. First each group (of one
/// source, from above or from the side) keeps its best ones up to an equal share of `max_grasps`,
/// as an arm that does not reach one group may reach another; then the best of the others follow. A
/// kept grasp may have a better one near that is not kept.
DistinctGrasps distinct_grasps(std::vector<Grasp> grasps, GripperKind kind,
                               const GraspOptions& options);

}  // namespace symscene
