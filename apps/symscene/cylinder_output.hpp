#pragma once

#include <string>

#include "symscene/grasping/bounding_cylinders.hpp"

namespace symscene::app {

/// A table with one line per cluster: its cylinder and best grasp, or what failed.
std::string format_cylinders(const CylinderScene& scene, const GraspPlan& plan);

/// The text of cylinders.json (docs/formats.md): the clusters, and the members of grasps.json.
std::string format_cylinders_json(const CylinderScene& scene, const GraspPlan& plan,
                                  const Gripper& gripper);

/// The clusters as objects of a page, with their cylinders as classes.
SegmentationResult cylinders_as_objects(const CylinderScene& scene);

/// The number of clusters with a cylinder.
std::size_t cylinder_count(const CylinderScene& scene);

}  // namespace symscene::app
