#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symscene/core/grasp.hpp"
#include "symscene/core/gripper.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/grasping/cylinder_options.hpp"

namespace symscene {

/// A cylinder around points.
struct BoundingCylinder {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< on the axis, midway between the caps [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of the axis, a unit vector
  double radius = 0.0;                                   ///< [m]
  double height = 0.0;                                   ///< distance between the caps [m]
};

/// The smallest cylinder about `axis` that holds all points: its radius is their greatest distance
/// from the axis, its caps are at the first and the last point along it (section 4.6.2). Throws
/// InputError if there is no point.
BoundingCylinder bounding_cylinder(const Points& points, const RotationAxis& axis);

/// A cluster and its bounding cylinder, or the bound that its axis fails.
struct ClusterCylinder {
  PointIndices points;  ///< into the cloud of CylinderScene, ascending
  std::optional<BoundingCylinder> cylinder = {};
  AxisQuality quality = {};  ///< of the axis; the defaults without a fit
  AxisJudgement judgement = {};
};

/// The clusters of a scene with their cylinders.
struct CylinderScene {
  PointCloud cloud;  ///< sampled, with unit normals
  std::optional<Plane> table;
  std::vector<ClusterCylinder> clusters;  ///< largest first
  std::vector<StageTime> timings;
  std::vector<std::string> warnings;  ///< those of the scene first
};

/// Euclidean clusters of a scene's cloud, and the cylinder about the axis of each (section 4.6.2).
/// The directions of cylinders point away from the table. Without occupancy, no axis is rejected
/// for space that was seen empty. A cloud without points has no cluster. The result has the same
/// bits for any number of threads. Throws InputError if an option is invalid or no point of the
/// cloud is usable.
CylinderScene fit_cylinders(const Scene& scene, const CylinderOptions& options = {},
                            const StageTimer::OnBegin& on_begin = {});

/// Grasps that envelop cylinders around their axes (section 4.6.3): from the side at several
/// heights, the fingers on both sides of the axis, and along the axis from both ends. Rejected are
/// cylinders that do not fit between the fingers and grasps in which the gripper reaches into the
/// table; nothing else is checked. `quality` is a preference, not a probability: the mean of how
/// near the pads are to the middle of the cylinder and how steep the approach is. `object` is the
/// index of a cluster. Throws InputError if the gripper or an option is invalid.
GraspPlan cylinder_grasps(const CylinderScene& scene, const Gripper& gripper,
                          const CylinderGraspOptions& options = {});

/// The grasps of fit_cylinders() and cylinder_grasps(), best first: the thesis's simple path from a
/// scene to grasps, as a baseline.
std::vector<Grasp> plan_cylinder_grasps(const Scene& scene, const Gripper& gripper,
                                        const CylinderOptions& options = {});

}  // namespace symscene
