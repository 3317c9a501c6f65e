#pragma once

#include <span>
#include <vector>

#include "symscene/grasping/bounding_cylinders.hpp"

namespace symscene {

/// A pose of the gripper around a cylinder.
struct CylinderCandidate {
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  double offset = 0.0;  ///< along the axis from the cylinder's middle to that of the pads [m]
  double reach = 0.0;   ///< how far the finger tips pass the axis or the nearer cap [m]
};

/// Poses that envelop the cylinder: from the side the fingers pass the axis, up to the far side if
/// they are long enough; along the axis they hold it at both ends of a diameter (section 4.6.3).
std::vector<CylinderCandidate> cylinder_candidates(const BoundingCylinder& cylinder,
                                                   const Gripper& gripper,
                                                   const CylinderGraspOptions& options);

/// A box in the tool frame.
using CylinderBox = Eigen::AlignedBox3d;

/// The boxes that the palm and the fingers of the open gripper pass through on their straight way
/// to the grasp. Fingers are as thick as at the palm.
std::vector<CylinderBox> swept_boxes(const Gripper& gripper);

/// The least signed distance of the boxes from the plane. [m]
double height_above(const Plane& plane, const Eigen::Isometry3d& T_world_tool,
                    std::span<const CylinderBox> boxes);

/// The greatest depth of a point in a box, from its nearest face; 0 if none is inside. [m]
double depth_of_points(const Points& points_world, const Eigen::Isometry3d& T_world_tool,
                       std::span<const CylinderBox> boxes);

}  // namespace symscene
