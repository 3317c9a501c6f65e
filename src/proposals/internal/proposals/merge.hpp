#pragma once

#include <span>
#include <vector>

#include "symscene/proposals/proposals.hpp"

namespace symscene {

/// A hypothesis with its confidence (section 4.3.3), indices into the scene's cloud.
struct RatedHypothesis {
  Hypothesis hypothesis;
  double confidence = 0.0;
};

/// Appends hypotheses with their confidence within the bounds of their stream.
void append_rated(const std::vector<Hypothesis>& hypotheses, const HypothesisBounds& bounds,
                  std::vector<RatedHypothesis>& rated);

/// Whether two ascending lists of indices overlap by more than `same_object` [IoU].
bool cover_same_points(std::span<const Index> a, std::span<const Index> b, double same_object);

/// Merges hypotheses of the same object (section 4.4), most confident ones first.
std::vector<MergedHypothesis> merge_hypotheses(std::vector<RatedHypothesis> hypotheses,
                                               const PointCloud& cloud,
                                               const MergeOptions& options = {});

}  // namespace symscene
