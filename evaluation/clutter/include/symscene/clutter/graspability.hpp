#pragma once

#include "symscene/core/geometry.hpp"
#include "symscene/core/gripper.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Whether a hand can close on an object that stands alone.
struct Graspability {
  bool at_all = false;      ///< in some pose
  bool as_it_lies = false;  ///< and the hand has room above the table
};

/// Draws lines from points of a closed surface along their inward normals. A line is a grasp if it
/// leaves the solid again between `min_width` and the gripper's opening from its start, at a normal
/// within the friction angle of the gripper, if the open hand can come straight to it, from one of
/// twelve directions around it and with tips up to 1 cm beyond it, without entering the solid, and
/// if what its pads then touch first faces them within the friction angle. No clearance is asked
/// for. `mesh` and `table` in one frame. [m] Throws InputError if the gripper is not a parallel
/// one.
Graspability graspability(const TriangleMesh& mesh, const Plane& table, const Gripper& gripper,
                          double min_width = 0.001);

}  // namespace symscene
