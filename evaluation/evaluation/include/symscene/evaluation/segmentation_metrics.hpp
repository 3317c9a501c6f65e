#pragma once

#include <cstdint>
#include <span>

#include "symscene/core/neighbors.hpp"
#include "symscene/evaluation/mask_metrics.hpp"

namespace symscene {

/// The metrics of unseen-object segmentation (Dave et al. 2019; Xie et al. 2020), each in [0, 1],
/// or sums of them over scenes.
struct SegmentationMetrics {
  double overlap_precision = 0.0;
  double overlap_recall = 0.0;
  double overlap_f = 0.0;
  double boundary_precision = 0.0;
  double boundary_recall = 0.0;
  double boundary_f = 0.0;
  double with_boundary = 0.0;  ///< scenes whose true masks have a boundary
  double found_75 = 0.0;       ///< share of true objects with an overlap F ≥ 0.75

  /// Whether the boundary metrics say anything: some true masks have a boundary.
  bool has_boundary() const { return with_boundary > 0.0; }

  SegmentationMetrics& operator+=(const SegmentationMetrics& other);
  /// The mean of a sum over `scenes`. The boundary metrics are averaged over the scenes with a
  /// boundary, and are 0 if none has one.
  SegmentationMetrics mean(std::size_t scenes) const;
};

/// Overlap and boundary precision, recall and F of the masks of one scene. True and found masks are
/// assigned one to one for the greatest sum of overlap F. Precision is over all points (boundary
/// points) of all found masks, recall over those of all true masks; both are 1 without points.
///
/// Adapted from images to point clouds: masks are made disjoint by label_points(); a boundary point
/// is a point of a mask with a neighbour in another mask; two boundary points match if they are
/// equal or neighbours. `neighbors` has a fixed radius of about two spacings of the cloud. An
/// isolated object has no boundary, as the table is not in the cloud, and points without a label
/// make none: beside a true mask they are often points that were not labelled.
SegmentationMetrics segmentation_metrics(const std::vector<PointIndices>& truth,
                                         const std::vector<PointIndices>& found,
                                         const NeighborLists& neighbors);

/// The same on the pixels of label images (0 is no object, k is object k), as Xie et al. 2020
/// define it: a boundary pixel is a pixel of a mask beside another label, and two of them match
/// within a disc of 0.3 % of the image's diagonal, rounded up. Here `found_75` is the share of the
/// true objects with an overlap F > 0.75. Throws InputError if the images are not of that size.
SegmentationMetrics pixel_metrics(std::span<const std::uint16_t> truth,
                                  std::span<const std::uint16_t> found, std::size_t width,
                                  std::size_t height);

}  // namespace symscene
