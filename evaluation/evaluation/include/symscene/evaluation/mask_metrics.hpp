#pragma once

#include <vector>

#include "symscene/core/point_cloud.hpp"
#include "symscene/ground_truth/mask_transfer.hpp"

namespace symscene {

/// Intersection over union (Eq. 4.16) of every true mask (row) with every found mask (column).
using OverlapMatrix = Eigen::MatrixXd;

/// The matrix of two lists of masks, each of ascending indices into the same cloud.
OverlapMatrix overlap_matrix(const std::vector<PointIndices>& truth,
                             const std::vector<PointIndices>& found);

/// Counts for precision, recall and F. Counts of several scenes are added.
struct DetectionCounts {
  std::size_t correct = 0;       ///< elements of the ground truth that were found
  std::size_t found = 0;         ///< returned elements that count as right or wrong
  std::size_t ground_truth = 0;  ///< elements of the ground truth

  double precision() const { return ratio(correct, found); }
  double recall() const { return ratio(correct, ground_truth); }
  double f_measure() const { return ratio(2 * correct, found + ground_truth); }

  DetectionCounts& operator+=(const DetectionCounts& other) {
    correct += other.correct;
    found += other.found;
    ground_truth += other.ground_truth;
    return *this;
  }

 private:
  /// 1 for an empty whole.
  static double ratio(std::size_t part, std::size_t whole) {
    return whole == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// Eqs. 4.14, 4.15: a true object counts as found if some mask overlaps it by more than
/// `min_overlap`; every returned mask counts in the precision.
DetectionCounts mask_detections(const OverlapMatrix& overlaps, double min_overlap);

/// The best overlap of every true object; 0 if no mask was found.
std::vector<double> best_overlaps(const OverlapMatrix& overlaps);

}  // namespace symscene
