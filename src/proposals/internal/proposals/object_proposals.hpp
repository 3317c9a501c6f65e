#pragma once

#include <vector>

#include "segmentation/workspace.hpp"
#include "symscene/proposals/proposals.hpp"
#include "symscene/proposals/selection_options.hpp"

namespace symscene {

/// The proposals of a scene: the hypotheses of both streams and the parts of the surface, merged
/// (section 4.4), pairs that continue each other joined, with features and scores. By falling
/// score.
std::vector<ObjectProposal> object_proposals(const Workspace& space,
                                             const std::vector<Hypothesis>& rotational,
                                             const std::vector<Hypothesis>& reflectional,
                                             const ProposalOptions& options);

/// The objects that select_probable() chooses among the proposals, with the symmetries of their
/// hypotheses. The others are appended to `rejected`.
std::vector<SceneObject> probable_objects(const SceneProposals& proposals,
                                          const SelectionOptions& options,
                                          std::vector<Rejection>& rejected);

}  // namespace symscene
