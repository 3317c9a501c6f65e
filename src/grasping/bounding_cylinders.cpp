#include "symscene/grasping/bounding_cylinders.hpp"

#include <algorithm>
#include <utility>

#include "core/parallel.hpp"
#include "pipeline/stage_options.hpp"
#include "segmentation/workspace.hpp"
#include "symmetry/segment_axis.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// The stages of the pipeline's preparation that this path needs, with its defaults.
Workspace sampled(const Scene& scene, const CylinderOptions& options, StageTimer& timer) {
  WorkspaceOptions space = workspace_options(PipelineOptions{});
  space.voxel_size = options.voxel_size;
  return sampled_workspace(scene, space, timer);
}

RotationAxis pointing_along(RotationAxis axis, const std::optional<Eigen::Vector3d>& up) {
  if (up && axis.direction.dot(*up) < 0.0) axis.direction = -axis.direction;
  return axis;
}

ClusterCylinder fit_cylinder(const Workspace& space, PointIndices cluster,
                             const RotationalDetectionOptions& options) {
  const SegmentAxis found = segment_axis(space.cloud, cluster, space.field, space.up, options);
  ClusterCylinder result;
  result.quality = found.candidate.quality;
  result.judgement = found.judgement;
  if (found.judgement.outcome == AxisOutcome::accepted) {
    result.cylinder = bounding_cylinder(select(space.cloud, cluster).positions,
                                        pointing_along(found.candidate.axis, space.up));
  }
  result.points = std::move(cluster);
  return result;
}

}  // namespace

BoundingCylinder bounding_cylinder(const Points& points, const RotationAxis& axis) {
  if (points.rows() == 0) throw InputError("bounding cylinder", "at least one point", "none");
  BoundingCylinder cylinder;
  cylinder.direction = axis.direction;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d point = points.row(i).transpose().cast<double>();
    const double along = axis.direction.dot(point - axis.point);
    low = std::min(low, along);
    high = std::max(high, along);
    cylinder.radius = std::max(cylinder.radius, axis.distance(point));
  }
  cylinder.center = axis.point + 0.5 * (low + high) * axis.direction;
  cylinder.height = high - low;
  return cylinder;
}

CylinderScene fit_cylinders(const Scene& scene, const CylinderOptions& options,
                            const StageTimer::OnBegin& on_begin) {
  options.validate();
  CylinderScene result;
  result.table = scene.table;
  result.warnings = scene.warnings;
  if (scene.cloud.empty()) return result;
  StageTimer timer(on_begin);
  Workspace space = sampled(scene, options, timer);
  std::vector<PointIndices> clusters =
      timer.time("clusters", [&] { return euclidean_clusters(space.cloud, options.clusters); });
  result.clusters.resize(clusters.size());
  timer.time("axes and cylinders", [&] {  // sections 3.5.2 and 4.6.2
    parallel_for_each(clusters.size(), [&](std::size_t i) {
      result.clusters[i] = fit_cylinder(space, std::move(clusters[i]), options.axis);
    });
  });
  result.cloud = std::move(space.cloud);
  result.timings = timer.stages();
  result.warnings = std::move(space.warnings);
  return result;
}

}  // namespace symscene
