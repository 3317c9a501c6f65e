#include "symscene/evaluation/mask_metrics.hpp"

#include <algorithm>

namespace symscene {

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
