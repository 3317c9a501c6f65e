#pragma once

#include <string>
#include <vector>

#include "symscene/clutter/clutter_methods.hpp"
#include "symscene/clutter/table_look.hpp"
#include "symscene/core/gripper.hpp"

namespace symscene {

/// An object that a method found in a look.
struct FoundObject {
  Points points;           ///< its observed points, in the world frame
  std::size_t grasps = 0;  ///< proposed
  std::string reason;      ///< why it has no grasp, if it has none
};

/// What a method proposes for a look.
struct TableProposals {
  std::vector<Grasp> grasps;  ///< best first, in the world frame; `object` is an index into objects
  std::vector<FoundObject> objects;
  double segmentation_seconds = 0.0;  ///< wall time from the scene to its objects
  double grasping_seconds = 0.0;      ///< wall time from the objects to their grasps
};

/// Throws InputError if the method needs true meshes: only symscene and cylinders start from a
/// look.
void require_sensed_method(GraspMethod method);

/// Grasps of the objects in a look. Throws InputError if the method needs true meshes.
TableProposals propose_table_grasps(GraspMethod method, const TableLook& look,
                                    const Gripper& gripper, const PipelineOptions& pipeline,
                                    const GraspOptions& grasping);

}  // namespace symscene
