#pragma once

#include <vector>

#include "segmentation/workspace.hpp"
#include "symmetry/object_symmetry.hpp"
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

/// The indices of the proposals that select_probable() chooses. The others are appended to
/// `rejected`.
std::vector<std::size_t> probable_proposals(const SceneProposals& proposals,
                                            const SelectionOptions& options,
                                            std::vector<Rejection>& rejected);

/// Proposal `k` as the object whose symmetries are searched, with the planes that the scene
/// proposes for its points.
SearchedObject searched_object(const SceneProposals& proposals, std::size_t k,
                               const ObjectSymmetryOptions& options);

/// The object that a proposal becomes, with those of its symmetry candidates that are probable.
SceneObject probable_object(const ObjectProposal& proposal, const SymmetryCandidates& candidates,
                            const ObjectSymmetryOptions& options);

}  // namespace symscene
