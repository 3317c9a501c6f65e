#pragma once

#include <utility>
#include <vector>

#include "symscene/proposals/proposals.hpp"

namespace symscene {

/// Which proposals continue each other behind an occluder.
struct Continuations {
  std::vector<double> continued;  ///< of each proposal, the greatest continuation by another
  /// Indices of proposals that are joined, the better one first.
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

/// Compares proposals by falling own_score.
Continuations find_continuations(const PointCloud& cloud, const DistanceField& field,
                                 const std::vector<ObjectProposal>& proposals,
                                 const ContinuationOptions& options);

/// The union of each pair, without those that nearly equal (`same_object`, IoU) a proposal or an
/// earlier union.
std::vector<SceneObject> joined_pairs(const PointCloud& cloud,
                                      const std::vector<ObjectProposal>& proposals,
                                      const Continuations& continuations, double same_object);

/// Suppresses parts of a likely joined object: sets the discount of each proposal inside one of
/// the joined pairs, which are among `proposals`, by the probability of the likeliest such pair.
void discount_parts(const std::vector<PointIndices>& joined, const ContinuationOptions& options,
                    std::vector<ObjectProposal>& proposals);

}  // namespace symscene
