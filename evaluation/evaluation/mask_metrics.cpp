#include "symscene/evaluation/mask_metrics.hpp"

#include <algorithm>

#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

/// For each point of the labelled cloud the first true object that holds it.
std::vector<Index> labels_of(const PointCloud& labeled, const SceneTruth& truth) {
  std::vector<Index> labels(labeled.size(), CellList::none);
  for (std::size_t k = truth.objects.size(); k-- > 0;) {
    for (const Index i : truth.objects[k].points) {
      if (i >= labels.size()) {
        throw InputError("ground truth of " + truth.objects[k].name,
                         "indices below " + std::to_string(labels.size()), std::to_string(i));
      }
      labels[i] = static_cast<Index>(k);
    }
  }
  return labels;
}

}  // namespace

std::vector<PointIndices> transfer_masks(const PointCloud& labeled, const SceneTruth& truth,
                                         const PointCloud& target, float radius) {
  std::vector<PointIndices> masks(truth.objects.size());
  const std::vector<Index> labels = labels_of(labeled, truth);
  const CellList cells(labeled.positions, radius);
  for (Index i = 0; i < target.size(); ++i) {
    const Index nearest = cells.nearest(target.position(i), radius).first;
    if (nearest == CellList::none || labels[nearest] == CellList::none) continue;
    masks[labels[nearest]].push_back(i);
  }
  return masks;
}

OverlapMatrix overlap_matrix(const std::vector<PointIndices>& truth,
                             const std::vector<PointIndices>& found) {
  OverlapMatrix overlaps(static_cast<Eigen::Index>(truth.size()),
                         static_cast<Eigen::Index>(found.size()));
  for (Index t = 0; t < truth.size(); ++t) {
    for (Index f = 0; f < found.size(); ++f) {
      overlaps(t, f) = intersection_over_union(truth[t], found[f]);
    }
  }
  return overlaps;
}

DetectionCounts mask_detections(const OverlapMatrix& overlaps, double min_overlap) {
  DetectionCounts counts;
  counts.found = static_cast<std::size_t>(overlaps.cols());
  counts.ground_truth = static_cast<std::size_t>(overlaps.rows());
  for (const double best : best_overlaps(overlaps)) counts.correct += best > min_overlap ? 1 : 0;
  return counts;
}

std::vector<double> best_overlaps(const OverlapMatrix& overlaps) {
  std::vector<double> best;
  for (Eigen::Index t = 0; t < overlaps.rows(); ++t) {
    best.push_back(overlaps.cols() == 0 ? 0.0 : overlaps.row(t).maxCoeff());
  }
  return best;
}

}  // namespace symscene
