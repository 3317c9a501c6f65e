#include "symscene/clutter/table_grasps.hpp"

#include "stopwatch.hpp"
#include "symscene/core/error.hpp"
#include "symscene/grasping/bounding_cylinders.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene {
namespace {

Points world_points(const PointCloud& cloud, const PointIndices& indices,
                    const Eigen::Isometry3d& T_world_scene) {
  const Eigen::Isometry3f T = T_world_scene.cast<float>();
  Points points(static_cast<Eigen::Index>(indices.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = (T * cloud.position(indices[static_cast<std::size_t>(i)])).transpose();
  return points;
}

/// Takes the grasps of a plan whose objects have these points of a cloud.
template <class Objects>
void take_table_plan(GraspPlan plan, const PointCloud& cloud, const Objects& objects,
                     const Eigen::Isometry3d& T_world_scene, TableProposals& proposals) {
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const ObjectGraspSummary& summary = plan.objects[k];
    proposals.objects.push_back({world_points(cloud, objects[k].points, T_world_scene),
                                 summary.grasps,
                                 summary.reason ? description(*summary.reason) : ""});
  }
  proposals.grasps = std::move(plan.grasps);
  for (Grasp& grasp : proposals.grasps) grasp.T_world_tool = T_world_scene * grasp.T_world_tool;
}

}  // namespace

void require_sensed_method(GraspMethod method) {
  if (method != GraspMethod::symscene && method != GraspMethod::cylinders)
    throw InputError("the method", "symscene or cylinders", to_string(method));
}

TableProposals propose_table_grasps(GraspMethod method, const TableLook& look,
                                    const Gripper& gripper, const PipelineOptions& pipeline,
                                    const GraspOptions& grasping) {
  require_sensed_method(method);
  TableProposals proposals;
  if (look.scene.cloud.empty()) return proposals;
  const Stopwatch watch;
  if (method == GraspMethod::cylinders) {
    const CylinderScene cylinders = fit_cylinders(look.scene);
    proposals.segmentation_seconds = watch.seconds();
    take_table_plan(cylinder_grasps(cylinders, gripper), cylinders.cloud, cylinders.clusters,
                    look.T_world_scene, proposals);
  } else {
    const SegmentationResult result = segment_scene(look.scene, pipeline);
    proposals.segmentation_seconds = watch.seconds();
    take_table_plan(plan_grasps(grasp_scene(result, &look.scene, grasping), gripper, grasping),
                    result.cloud, result.objects, look.T_world_scene, proposals);
  }
  proposals.grasping_seconds = watch.seconds() - proposals.segmentation_seconds;
  return proposals;
}

}  // namespace symscene
