#pragma once

#include "proposal_draft.hpp"
#include "segmentation/workspace.hpp"

namespace symscene {

/// The hypotheses of the classes of the best drafts that repeat no draft, with the symmetries of
/// draft and class. `drafts` come by falling own_score.
std::vector<MergedHypothesis> class_proposals(const Workspace& space,
                                              const std::vector<ProposalDraft>& drafts,
                                              const ProposalOptions& options);

}  // namespace symscene
