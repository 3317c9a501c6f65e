#pragma once

#include "table_belief.hpp"

namespace symscene {

/// The thesis's simple path (section 4.6): Euclidean clusters, their bounding cylinders as
/// completed shapes, and grasps around these. Space that was never seen is not considered.
TableBelief cylinder_belief(const Scene& scene, const Gripper& gripper, StageTimer& timer);

}  // namespace symscene
