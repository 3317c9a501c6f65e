#pragma once

#include "symscene/core/neighbors.hpp"
#include "symscene/evaluation/mask_metrics.hpp"

namespace symscene {

/// The one-to-one pairs of rows and columns with the greatest sum of gains (the Hungarian method,
/// O(n³)), by row. Pairs without any gain are left out. Gains are at least 0.
std::vector<MaskPair> assign_masks(const OverlapMatrix& gains);

/// The point's mask among masks that may overlap: the first that holds it, so that masks by falling
/// score give each point the best. `unlabeled` where none does.
inline constexpr Index unlabeled = ~Index{0};
std::vector<Index> label_points(const std::vector<PointIndices>& masks, std::size_t point_count);

/// What the field of unseen-object segmentation reports (Dave et al. 2019; Xie et al. 2020), each
/// in [0, 1], or sums of them over scenes.
struct SegmentMetrics {
  double overlap_precision = 0.0;
  double overlap_recall = 0.0;
  double overlap_f = 0.0;
  double boundary_precision = 0.0;
  double boundary_recall = 0.0;
  double boundary_f = 0.0;
  double with_boundary = 0.0;  ///< 1 where true masks have a boundary; others do not count for it
  double found_75 = 0.0;       ///< share of the true objects with an overlap F of at least 0.75

  SegmentMetrics& operator+=(const SegmentMetrics& other);
  /// Of a sum over `scenes` their mean; that of the boundary is over the scenes that have one, and
  /// 0 where none has.
  SegmentMetrics mean(std::size_t scenes) const;
};

/// Overlap and boundary precision, recall and F of the masks of one scene, true ones and found ones
/// assigned one to one for the greatest sum of overlap F. Precision is over all points (boundary
/// points) of all found masks, recall over those of all true ones; of nothing it is one.
///
/// The adaptation from images to point clouds: masks are made disjoint as label_points() does; a
/// boundary point is a point of a mask with a neighbour of another label, or of none; two boundary
/// points meet if they are one or neighbours. `neighbors` is of one radius, about two spacings of
/// the cloud. What stands free of everything has no boundary, as the table is not in the cloud.
SegmentMetrics segment_metrics(const std::vector<PointIndices>& truth,
                               const std::vector<PointIndices>& found,
                               const NeighborLists& neighbors);

}  // namespace symscene
