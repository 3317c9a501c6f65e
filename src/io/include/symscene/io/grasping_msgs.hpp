#pragma once

#include <span>
#include <string>

#include "symscene/io/moveit.hpp"

namespace symscene {

/// The result of the action grasping_msgs/FindGraspableObjects by the names of its fields:
/// {"objects": [grasping_msgs/GraspableObject], "support_surfaces": [grasping_msgs/Object]}. Each
/// object has its closed surface as a mesh, and its grasps, best first; an object without a surface
/// has no mesh. The table is the support surface. `classes`: names of the objects' symmetry
/// classes, empty where none is known. Fields that are left out have their default. Throws
/// InputError if a number is not finite.
std::string format_graspable_objects_json(const MoveItScene& scene,
                                          std::span<const std::string> classes = {},
                                          RosVersion version = RosVersion::ros2);

/// The same as YAML.
std::string format_graspable_objects_yaml(const MoveItScene& scene,
                                          std::span<const std::string> classes = {},
                                          RosVersion version = RosVersion::ros2);

}  // namespace symscene
