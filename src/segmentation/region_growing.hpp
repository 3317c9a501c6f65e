#pragma once

#include "symscene/segmentation/oversegmentation.hpp"

namespace symscene {

/// For every point 1 − the mean cosine between its normal and its neighbours': zero on a plane, one
/// without neighbours.
std::vector<float> curvatures(const PointCloud& cloud, const NeighborLists& neighbors);

/// Smooth segments by region growing from the flattest point, at one angle (section 3.5.1): a point
/// adds its smooth neighbours only if enough of those not yet assigned are smooth, which stops
/// leaks over rounded edges. Segments are disjoint and ascending, in the order in which they were
/// grown. `cloud` has unit normals; `max_angle` in rad.
std::vector<PointIndices> grow_regions(const PointCloud& cloud, const NeighborLists& neighbors,
                                       double max_angle, const OversegmentationOptions& options);

}  // namespace symscene
