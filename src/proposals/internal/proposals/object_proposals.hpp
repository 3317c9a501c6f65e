#pragma once

#include "segmentation/workspace.hpp"
#include "symscene/proposals/proposals.hpp"

namespace symscene {

/// Joins the cuts of both streams and the parts of the surface: equal sets become one proposal with
/// all symmetries. Measures and scores them. By falling score. `proposals` holds the cuts.
std::vector<ObjectProposal> object_proposals(const Workspace& space,
                                             const SceneProposals& proposals,
                                             const ProposalOptions& options);

}  // namespace symscene
