#pragma once

#include <vector>

#include "symscene/core/scene.hpp"

namespace symscene {

/// Intersection over union (Eq. 4.16) of every true mask (a row) with every found one (a column).
using OverlapMatrix = Eigen::MatrixXd;

/// The true masks as sets of points of another cloud of the same scene, such as the thinned cloud
/// of a result: each of its points takes the label of the nearest point of the cloud that the truth
/// counts in, if one is within `radius`. [m]
std::vector<PointIndices> transfer_masks(const PointCloud& labeled, const SceneTruth& truth,
                                         const PointCloud& target, float radius = 0.01F);

/// Both lists hold ascending indices into the same cloud.
OverlapMatrix overlap_matrix(const std::vector<PointIndices>& truth,
                             const std::vector<PointIndices>& found);

/// A true mask and the found one that stands for it.
struct MaskPair {
  Index truth = 0;
  Index found = 0;
  double overlap = 0.0;
};

/// One-to-one pairs by falling overlap, down to overlaps above `min_overlap`. Ties go to the lower
/// indices. Above one half no two masks compete where masks do not overlap, and the pairs are the
/// best ones.
std::vector<MaskPair> match_masks(const OverlapMatrix& overlaps, double min_overlap);

/// What was right among what was found and what was to be found. Sums over scenes are sums of the
/// counts.
struct Score {
  std::size_t correct = 0;  ///< true things that were found
  std::size_t found = 0;    ///< things that were returned and are right or wrong
  std::size_t truth = 0;    ///< things that were to be found

  double precision() const { return ratio(correct, found); }
  double recall() const { return ratio(correct, truth); }
  double f_measure() const { return ratio(2 * correct, found + truth); }

  Score& operator+=(const Score& other) {
    correct += other.correct;
    found += other.found;
    truth += other.truth;
    return *this;
  }

 private:
  /// Zero of nothing is all of it.
  static double ratio(std::size_t part, std::size_t whole) {
    return whole == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// Eqs. 4.14, 4.15: a true object counts as found if some mask overlaps it by more than
/// `min_overlap`; every mask that was returned counts in the precision.
Score mask_score(const OverlapMatrix& overlaps, double min_overlap);

/// The best overlap of every true object; zero where nothing was found.
std::vector<double> best_overlaps(const OverlapMatrix& overlaps);

/// Their mean; one where there is no true object.
double mean_best_overlap(const OverlapMatrix& overlaps);

}  // namespace symscene
