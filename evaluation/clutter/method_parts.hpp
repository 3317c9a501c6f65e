#pragma once

#include <span>
#include <vector>

#include "clutter/view_rendering.hpp"
#include "symscene/clutter/clutter_methods.hpp"
#include "symscene/grasping/planner.hpp"

namespace symscene {

class Random;

/// Poses whose fingertips enclose a random point of the surface, approached from above or the side
/// from a random direction.
std::vector<Grasp> random_grasps(const ClutterWorld& world, const Gripper& gripper, Random random);

/// Grasps across two opposite points of a surface whose normals lie within 20 degrees of it, by
/// uniformly distributed points and directions of approach from above or the side. Nothing is said
/// of collisions.
std::vector<Grasp> random_antipodal_grasps(const ClutterWorld& world, const Gripper& gripper,
                                           Random random);

/// The true meshes as completed objects that were seen from everywhere.
GraspScene true_grasp_scene(const ClutterWorld& world);

/// The factor by which the depths of an image are too large if its most frequent plane is the
/// table; 1 if it shows no table.
double depth_scale(const ClutterView& view, const CameraIntrinsics& camera, const Plane& table);

}  // namespace symscene
