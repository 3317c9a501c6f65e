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
  ReflectionalDetection of_curves = detect_reflectional_by_curves(
      input.cloud, scene_curves(input.cloud, options), input.field, options.curve_detection);
  planes.candidates =
      united_candidates(std::move(planes.candidates), std::move(of_curves.candidates), input.cloud,
                        options.curve_detection);
  planes.funnel.insert(planes.funnel.end(), of_curves.funnel.begin(), of_curves.funnel.end());
  planes.funnel.push_back({"reflectional: planes of both", planes.candidates.size()});
  return planes;
}

}  // namespace symscene
