#include "planes.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace symscene {
namespace {

/// The lengths of the options are for points 5 mm apart; of a coarser cloud they grow with the
/// spacing.
EdgeCurveOptions curves_at(double spacing, EdgeCurveOptions options) {
  options.radius = std::max(options.radius, 2.0 * spacing);
  options.spacing = std::max(options.spacing, spacing);
  options.link_distance = std::max(options.link_distance, 3.2 * spacing);
  options.tangent_radius = std::max(options.tangent_radius, 3.0 * spacing);
  options.min_length = std::max(options.min_length, 5.0 * spacing);
  return options;
}

CurveDetectionOptions detection_at(double spacing, CurveDetectionOptions options) {
  options.support_radius = std::max(options.support_radius, 3.0 * spacing);
  return options;
}

}  // namespace

std::vector<EdgeCurve> scene_curves(const PointCloud& cloud, const PipelineOptions& options) {
  const NeighborLists neighbors = voxel_neighbors(cloud.positions, options.voxel_size);
  const Partition partition = facets(cloud, neighbors, options.supervoxels);
  return edge_curves(cloud, neighbors, partition.labels,
                     curves_at(options.voxel_size, options.edge_curves));
}

ReflectionalDetection detect_planes(const PlaneInput& input, const PipelineOptions& options) {
  ReflectionalDetection planes;
  if (options.planes_of_surfaces)
    planes = detect_reflectional(input.cloud, input.segments, input.field, input.up,
                                 options.reflectional_detection);
  if (!options.planes_of_curves) return planes;
  ReflectionalDetection of_curves =
      detect_reflectional_by_curves(input.cloud, scene_curves(input.cloud, options), input.field,
                                    detection_at(options.voxel_size, options.curve_detection));
  std::vector<ReflectionalCandidate> further = further_candidates(
      std::move(of_curves.candidates), planes.candidates, input.cloud, options.curve_detection);
  planes.funnel.insert(planes.funnel.end(), of_curves.funnel.begin(), of_curves.funnel.end());
  planes.funnel.push_back({"curves: planes that segments do not propose", further.size()});
  std::move(further.begin(), further.end(), std::back_inserter(planes.candidates));
  return planes;
}

}  // namespace symscene
