#pragma once

#include <cstddef>
#include <vector>

#include "proposal_draft.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/proposals/proposal_options.hpp"

namespace symscene {

/// Two proposals that continue each other, by index, the better one first.
struct JoinedPair {
  std::size_t a = 0, b = 0;
  double continuation = 0.0;
};

/// Which proposals continue each other behind an occluder.
struct Continuations {
  std::vector<double> continued;  ///< of each proposal, the greatest continuation by another
  std::vector<JoinedPair> pairs;
};

/// Compares proposals, which come by falling own_score.
Continuations find_continuations(const PointCloud& cloud, const DistanceField& field,
                                 const std::vector<ProposalDraft>& proposals,
                                 const ContinuationOptions& options);

/// The union of each pair, without those that nearly equal (`same_object`, IoU) a proposal or an
/// earlier union.
std::vector<MergedHypothesis> joined_pairs(const std::vector<ProposalDraft>& proposals,
                                           const Continuations& continuations, double same_object);

/// Of each proposal the greatest continuation of two others by each other whose union it nearly
/// equals (`same_object`, IoU); 0 if there are none.
std::vector<double> joined_values(const std::vector<ProposalDraft>& proposals,
                                  const Continuations& continuations, double same_object);

}  // namespace symscene
