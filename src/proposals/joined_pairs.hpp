#pragma once

#include <utility>
#include <vector>

#include "proposal_draft.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/proposals/proposal_options.hpp"

namespace symscene {

/// Which proposals continue each other behind an occluder.
struct Continuations {
  std::vector<double> continued;  ///< of each proposal, the greatest continuation by another
  /// Indices of proposals that are joined, the better one first.
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

/// Compares proposals, which come by falling own_score.
Continuations find_continuations(const PointCloud& cloud, const DistanceField& field,
                                 const std::vector<ProposalDraft>& proposals,
                                 const ContinuationOptions& options);

/// The union of each pair, without those that nearly equal (`same_object`, IoU) a proposal or an
/// earlier union.
std::vector<MergedHypothesis> joined_pairs(const std::vector<ProposalDraft>& proposals,
                                           const Continuations& continuations, double same_object);

/// Suppresses parts of a likely joined object: the discount of each proposal inside a joined pair,
/// by the probability of the likeliest such pair. `probabilities` holds one per proposal.
std::vector<double> part_discounts(const std::vector<ProposalDraft>& proposals,
                                   const std::vector<double>& probabilities,
                                   const ContinuationOptions& options);

}  // namespace symscene
