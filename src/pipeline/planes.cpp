#include "planes.hpp"

namespace symscene {

std::vector<EdgeCurve> scene_curves(const PointCloud& cloud, const PipelineOptions& options) {
  const NeighborLists neighbors = voxel_neighbors(cloud.positions, options.voxel_size);
  const Partition partition = facets(cloud, neighbors, options.supervoxels);
  return edge_curves(cloud, neighbors, partition.labels, options.edge_curves);
}

ReflectionalDetection detect_planes(const PlaneInput& input, const PipelineOptions& options) {
  ReflectionalDetection planes;
  if (options.planes_of_surfaces)
    planes = detect_reflectional(input.cloud, input.segments, input.field, input.up,
                                 options.reflectional_detection);
  if (!options.planes_of_curves) return planes;
  const ReflectionalDetection of_curves = detect_reflectional_by_curves(
      input.cloud, scene_curves(input.cloud, options), input.field, options.curve_detection);
  const std::vector<ReflectionalCandidate> further = further_candidates(
      of_curves.candidates, planes.candidates, input.cloud, options.curve_detection);
  planes.candidates.insert(planes.candidates.end(), further.begin(), further.end());
  planes.funnel.insert(planes.funnel.end(), of_curves.funnel.begin(), of_curves.funnel.end());
  planes.funnel.push_back({"curves: planes that segments do not propose", further.size()});
  return planes;
}

}  // namespace symscene
