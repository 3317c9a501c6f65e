#pragma once

#include <utility>
#include <vector>

#include "symscene/core/point_cloud.hpp"
#include "symscene/segmentation/graph_cut.hpp"
#include "symscene/segmentation/surface_parts.hpp"

namespace symscene {

/// A supervoxel: connected points of about one size and one direction (Papon et al. 2013).
struct SurfacePatch {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit
  PointIndices points;                               ///< ascending
};

/// Patches that cover a cloud with unit normals: points go to the seed that is nearest along the
/// edges of the surface graph, with a cost for normals that differ from the patch's; the seeds
/// move to the middle of their patches, and the points are assigned again.
std::vector<SurfacePatch> surface_patches(const PointCloud& cloud,
                                          const std::vector<WeightedEdge>& edges,
                                          const SurfacePartsOptions& options);

/// The pairs a < b of patches that are near each other, whether or not edges join them: at depth
/// edges, and where a surface was seen at a grazing angle, points are missing between two faces of
/// one object.
std::vector<std::pair<Index, Index>> patches_across_gaps(const std::vector<SurfacePatch>& patches,
                                                         const SurfacePartsOptions& options);

/// How concave the surface is between two adjacent patches [rad]: the angle of the fold, 0 if it
/// is convex; at a step, the angle between the line of both centres and the surface. The mean
/// normals of patches make it less sensitive to noise than the normals of points.
float patch_concavity(const SurfacePatch& a, const SurfacePatch& b);

}  // namespace symscene
