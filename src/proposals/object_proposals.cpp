#include "proposals/object_proposals.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "class_proposals.hpp"
#include "core/model_features.hpp"
#include "core/parallel.hpp"
#include "joined_pairs.hpp"
#include "object_feature_extractor.hpp"
#include "proposals/merge.hpp"
#include "proposals/object_score.hpp"
#include "proposals/selection.hpp"
#include "segmentation/surface_regions.hpp"

namespace symscene {
namespace {

/// Folds [right angles] at which the partitions of the patches propose objects (Stein et al. 2014).
constexpr std::array fold_levels{0.05, 0.08, 0.12, 0.17, 0.24, 0.33, 0.45};

void append_parts(std::vector<PointIndices> parts, std::vector<RatedHypothesis>& rated) {
  for (PointIndices& part : parts) {
    Hypothesis hypothesis;
    hypothesis.points = std::move(part);
    rated.push_back({std::move(hypothesis), 0.0});
  }
}

/// The hypotheses of both streams and the parts of the surface, merged.
std::vector<MergedHypothesis> merged_hypotheses(const Workspace& space,
                                                const std::vector<Hypothesis>& rotational,
                                                const std::vector<Hypothesis>& reflectional,
                                                const SurfaceRegions& regions,
                                                const SurfaceRegions& patches,
                                                const ProposalOptions& options) {
  std::vector<RatedHypothesis> rated;
  append_rated(rotational, options.rotational_bounds, rated);
  append_rated(reflectional, options.reflectional_bounds, rated);
  std::erase_if(rated, [&](const RatedHypothesis& candidate) {
    return candidate.hypothesis.points.size() <
           static_cast<std::size_t>(options.surface_parts.min_size);
  });
  append_parts(regions.parts(), rated);
  append_parts(patches.parts_at(fold_levels), rated);
  return merge_hypotheses(std::move(rated), space.cloud, options.merge);
}

/// Adds drafts of proposals and sorts all by falling own_score.
void add_drafts(std::vector<MergedHypothesis> hypotheses, const ObjectFeatureExtractor& extractor,
                const ProposalOptions& options, std::vector<ProposalDraft>& drafts) {
  const TreeModel& model = chosen_model(options.object_alone, object_model());
  const std::size_t before = drafts.size();
  drafts.resize(before + hypotheses.size());
  parallel_for_each(hypotheses.size(), [&](std::size_t k) {
    const OwnFeatures features = extractor.features(hypotheses[k]);
    drafts[before + k] = {std::move(hypotheses[k]), features,
                          estimated_probability({features}, model)};
  });
  std::stable_sort(
      drafts.begin(), drafts.end(),
      [](const ProposalDraft& a, const ProposalDraft& b) { return a.own_score > b.own_score; });
}

/// The features of all proposals, with those that depend on the others.
std::vector<ObjectFeatures> completed_features(const std::vector<ProposalDraft>& drafts,
                                               const Continuations& continuations,
                                               double same_object) {
  const std::vector<double> joined = joined_values(drafts, continuations, same_object);
  std::vector<ObjectFeatures> features;
  for (std::size_t k = 0; k < drafts.size(); ++k)
    features.push_back({drafts[k].features, continuations.continued[k], joined[k]});
  return features;
}

/// One context per proposal.
std::vector<ProposalContext> contexts_of(const std::vector<ProposalDraft>& drafts,
                                         const std::vector<double>& estimates,
                                         const ProposalContextOptions& options) {
  std::vector<const PointIndices*> points;
  for (const ProposalDraft& draft : drafts) points.push_back(&draft.merged.points);
  return proposal_contexts(SharedCounts(points, options), estimates);
}

/// The proposals with their final features and scores, by falling score.
std::vector<ObjectProposal> final_proposals(std::vector<ProposalDraft> drafts,
                                            const std::vector<ObjectFeatures>& features,
                                            const ProposalOptions& options) {
  const TreeModel& alone = chosen_model(options.object_alone, object_model());
  const TreeModel& among_others = chosen_model(options.object_among_others, object_context_model());
  std::vector<double> estimates;
  for (const ObjectFeatures& own : features) estimates.push_back(estimated_probability(own, alone));
  const std::vector<ProposalContext> contexts =
      contexts_of(drafts, estimates, options.proposal_context);
  std::vector<ObjectProposal> proposals;
  for (std::size_t k = 0; k < drafts.size(); ++k) {
    const double score = pooled_probability(
        estimates[k], estimated_probability(features[k], contexts[k], among_others),
        options.proposal_context.own_weight);
    proposals.push_back({std::move(drafts[k].merged), features[k], drafts[k].own_score,
                         estimates[k], score, contexts[k]});
  }
  std::stable_sort(
      proposals.begin(), proposals.end(),
      [](const ObjectProposal& a, const ObjectProposal& b) { return a.score > b.score; });
  return proposals;
}

}  // namespace

std::vector<ObjectProposal> object_proposals(const Workspace& space,
                                             const std::vector<Hypothesis>& rotational,
                                             const std::vector<Hypothesis>& reflectional,
                                             const ProposalOptions& options) {
  const SurfaceRegions regions =
      smooth_regions(space.cloud, space.edges, space.neighbors, options.surface_parts);
  const SurfaceRegions patches = patch_regions(space.cloud, space.edges, options.surface_parts);
  const ObjectFeatureExtractor extractor({space.cloud, space.edges, space.field, regions, patches},
                                         options);
  const auto continuations = [&](const std::vector<ProposalDraft>& among) {
    return find_continuations(space.cloud, space.field, among, options.continuation);
  };
  const double same_object = options.merge.same_object;
  std::vector<ProposalDraft> drafts;
  add_drafts(merged_hypotheses(space, rotational, reflectional, regions, patches, options),
             extractor, options, drafts);
  if (options.class_segmentation.enabled)
    add_drafts(class_proposals(space, drafts, options), extractor, options, drafts);
  add_drafts(joined_pairs(drafts, continuations(drafts), same_object), extractor, options, drafts);
  // Joined pairs may be continued by a third proposal.
  const std::vector<ObjectFeatures> features =
      completed_features(drafts, continuations(drafts), same_object);
  return final_proposals(std::move(drafts), features, options);
}

std::vector<std::size_t> probable_proposals(const SceneProposals& proposals,
                                            const SelectionOptions& options,
                                            std::vector<Rejection>& rejected) {
  std::vector<SelectionCandidate> candidates;
  for (const ObjectProposal& proposal : proposals.objects)
    candidates.push_back(selection_candidate(proposal.merged, proposal.score));
  return select_probable(candidates, options, rejected);
}

SearchedObject searched_object(const SceneProposals& proposals, std::size_t k,
                               const ObjectSymmetryOptions& options) {
  const ObjectProposal& proposal = proposals.objects[k];
  SearchedObject object{proposal.merged.points, proposal.score};
  for (const ObjectAxis& own : proposal.merged.axes) object.axes.push_back(own.axis);
  for (const ObjectPlane& own : proposal.merged.planes) object.planes.push_back(own.plane);
  for (const ReflectionalCandidate& detected : proposals.planes) {
    const auto inside = static_cast<double>(intersection_size(detected.support, object.points));
    if (inside >= options.min_support_share * static_cast<double>(detected.support.size()))
      object.planes.push_back(detected.plane);
  }
  return object;
}

SceneObject probable_object(const ObjectProposal& proposal, const SymmetryCandidates& candidates,
                            const ObjectSymmetryOptions& options) {
  ListedSymmetries listed = list_symmetries(candidates, options);
  return {.points = proposal.merged.points,
          .score = proposal.score,
          .confidence = proposal.merged.confidence,
          .rotational = std::move(listed.rotational),
          .reflectional = std::move(listed.reflectional)};
}

}  // namespace symscene
