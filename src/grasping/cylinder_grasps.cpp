#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/parallel.hpp"
#include "cylinder_candidates.hpp"
#include "hand_collision.hpp"
#include "object_plan.hpp"
#include "symscene/grasping/bounding_cylinders.hpp"

namespace symscene {
namespace {

/// What a candidate failed; none for a valid one.
struct Refusal {
  GraspRejection reason;
  double value;
  double bound;
};

/// The bound of the gripper that the cylinder does not respect, whatever the pose.
std::optional<Refusal> misfit(const BoundingCylinder& cylinder, const Gripper& gripper,
                              const CylinderGraspOptions& options) {
  const double diameter = 2.0 * cylinder.radius;
  const double widest = gripper.max_opening - options.opening_margin;
  if (diameter > widest) return Refusal{GraspRejection::too_wide, diameter, widest};
  if (diameter < gripper.min_opening)
    return Refusal{GraspRejection::too_thin, diameter, gripper.min_opening};
  return std::nullopt;
}

/// What the gripper must not touch.
class Surroundings {
 public:
  /// The points of the cloud that are not in the cluster, which is ascending.
  Surroundings(const CylinderScene& scene, const PointIndices& cluster) : table_(scene.table) {
    Points points(scene.cloud.size() - static_cast<Index>(cluster.size()), 3);
    Eigen::Index row = 0;
    auto next = cluster.begin();
    for (Index i = 0; i < scene.cloud.size(); ++i) {
      if (next != cluster.end() && *next == i) {
        ++next;
      } else {
        points.row(row++) = scene.cloud.positions.row(i);
      }
    }
    others_ = surface_samples(points);
  }

  std::optional<Refusal> refusal(const Grasp& grasp, const HandShape& swept,
                                 const CylinderGraspOptions& options) const {
    if (table_) {
      const double height = height_over(*table_, grasp.T_world_tool, swept.boxes);
      if (height < options.table_clearance)
        return Refusal{GraspRejection::table, height, options.table_clearance};
    }
    const DistanceBounds bounds{0.0F, -std::numeric_limits<float>::infinity()};
    const Eigen::Isometry3f T_tool_world = grasp.T_world_tool.inverse().cast<float>();
    const float distance = least_distance(others_, T_tool_world, swept.boxes, bounds);
    if (distance < 0.0F) return Refusal{GraspRejection::other_object, distance, 0.0};
    return std::nullopt;
  }

 private:
  std::optional<Plane> table_;
  SurfaceSamples others_;
};

/// The mean of how near the pads are to the middle of the cylinder and how steep the approach is.
double preference(const CylinderCandidate& candidate, const BoundingCylinder& cylinder,
                  const Eigen::Vector3d& up) {
  const double half = 0.5 * cylinder.height;
  const double middle = half > 0.0 ? std::max(0.0, 1.0 - std::abs(candidate.offset) / half) : 1.0;
  const double steepness = 0.5 * (1.0 - candidate.T_world_tool.linear().col(2).dot(up));
  return std::clamp(0.5 * (middle + steepness), 0.0, 1.0);
}

/// The reason of most rejected candidates; of equally frequent ones the one checked last.
GraspRejection main_reason(const ObjectGraspSummary& summary) {
  const auto most = std::max_element(summary.rejected.rbegin(), summary.rejected.rend());
  return static_cast<GraspRejection>(summary.rejected.rend() - most - 1);
}

/// Thins the rejected candidates after counting them.
void summarize(ObjectPlan& plan, int max_rejected) {
  ObjectGraspSummary& summary = plan.summary;
  summary.grasps = plan.grasps.size();
  summary.candidates = summary.grasps + plan.rejected.size();
  std::vector<GraspRejection> reasons;
  for (const RejectedGrasp& rejected : plan.rejected) {
    ++summary.rejected[static_cast<std::size_t>(rejected.reason)];
    reasons.push_back(rejected.reason);
  }
  if (summary.candidates == 0) {
    summary.reason = GraspRejection::no_axis;
  } else if (summary.grasps == 0) {
    summary.reason = main_reason(summary);
  }
  std::vector<RejectedGrasp> kept;
  for (const Index i : some_of_each_reason(reasons, max_rejected)) kept.push_back(plan.rejected[i]);
  plan.rejected = std::move(kept);
}

/// All candidates of a cluster that has a cylinder.
void judge_candidates(const CylinderScene& scene, std::size_t id, const Gripper& gripper,
                      const CylinderGraspOptions& options, ObjectPlan& plan) {
  const BoundingCylinder& cylinder = *scene.clusters[id].cylinder;
  const Eigen::Vector3d up = scene.table ? scene.table->normal : Eigen::Vector3d::UnitZ();
  const Surroundings around(scene, scene.clusters[id].points);
  const HandShape swept = hand_shape(gripper, gripper.max_opening, gripper.approach_distance);
  const std::optional<Refusal> unfit = misfit(cylinder, gripper, options);
  for (const CylinderCandidate& candidate : cylinder_candidates(cylinder, gripper, options)) {
    const Grasp grasp{.object = static_cast<int>(id),
                      .T_world_tool = candidate.T_world_tool,
                      .opening = 2.0 * cylinder.radius,
                      .quality = preference(candidate, cylinder, up),
                      .source = GraspSource::cylinder};
    std::optional<Refusal> refusal = unfit;
    if (!refusal && candidate.reach < 0.0)
      refusal = Refusal{GraspRejection::no_contact, candidate.reach, 0.0};
    if (!refusal) refusal = around.refusal(grasp, swept, options);
    if (refusal) {
      plan.rejected.push_back({grasp, refusal->reason, refusal->value, refusal->bound});
    } else {
      plan.grasps.push_back(grasp);
    }
  }
}

ObjectPlan plan_cluster(const CylinderScene& scene, std::size_t id, const Gripper& gripper,
                        const CylinderGraspOptions& options) {
  ObjectPlan plan;
  if (scene.clusters[id].cylinder) judge_candidates(scene, id, gripper, options, plan);
  summarize(plan, options.max_rejected);
  return plan;
}

}  // namespace

GraspPlan cylinder_grasps(const CylinderScene& scene, const Gripper& gripper,
                          const CylinderGraspOptions& options) {
  gripper.validate();
  options.validate();
  StageTimer timer;
  GraspPlan plan = timer.time("cylinder grasps", [&] {  // section 4.6.3
    std::vector<ObjectPlan> clusters(scene.clusters.size());
    parallel_for_each(clusters.size(), [&](std::size_t id) {
      clusters[id] = plan_cluster(scene, id, gripper, options);
    });
    return joined(clusters);
  });
  plan.timings = timer.stages();
  return plan;
}

std::vector<Grasp> plan_cylinder_grasps(const Scene& scene, const Gripper& gripper,
                                        const CylinderOptions& options) {
  return cylinder_grasps(fit_cylinders(scene, options), gripper, options.grasps).grasps;
}

}  // namespace symscene
