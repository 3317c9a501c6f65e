#include "proposals/object_proposals.hpp"

#include <algorithm>
#include <utility>

#include "core/model_features.hpp"
#include "core/parallel.hpp"
#include "joined_pairs.hpp"
#include "object_meter.hpp"
#include "object_score.hpp"
#include "proposals/merge.hpp"
#include "proposals/selection.hpp"
#include "segmentation/surface_regions.hpp"

namespace symscene {
namespace {

/// The hypotheses of both streams and the parts of the surface, merged.
std::vector<MergedHypothesis> merged_hypotheses(const Workspace& space,
                                                const std::vector<Hypothesis>& rotational,
                                                const std::vector<Hypothesis>& reflectional,
                                                const SurfaceRegions& regions,
                                                const ProposalOptions& options) {
  std::vector<RatedHypothesis> rated;
  append_rated(rotational, options.rotational_bounds, rated);
  append_rated(reflectional, options.reflectional_bounds, rated);
  std::erase_if(rated, [&](const RatedHypothesis& candidate) {
    return candidate.hypothesis.points.size() <
           static_cast<std::size_t>(options.surface_parts.min_size);
  });
  for (PointIndices& part : regions.parts()) {
    Hypothesis hypothesis;
    hypothesis.points = std::move(part);
    rated.push_back({std::move(hypothesis), 0.0});
  }
  return merge_hypotheses(std::move(rated), space.cloud, options.merge);
}

/// Adds drafts of proposals and sorts all by falling own_score.
void add_drafts(std::vector<MergedHypothesis> hypotheses, bool are_joined_pairs,
                const ObjectMeter& meter, const ProposalOptions& options,
                std::vector<ProposalDraft>& drafts) {
  const TreeModel& model = chosen_model(options.object_alone, object_model());
  const double weight = options.object_score.confidence_weight;
  const std::size_t before = drafts.size();
  drafts.resize(before + hypotheses.size());
  parallel_for_each(hypotheses.size(), [&](std::size_t k) {
    const ObjectFeatures features = meter.measure(hypotheses[k]);
    const double own_score =
        combined_score(estimated_probability(features, model), features.confidence, weight);
    drafts[before + k] = {std::move(hypotheses[k]), features, own_score, are_joined_pairs};
  });
  std::stable_sort(
      drafts.begin(), drafts.end(),
      [](const ProposalDraft& a, const ProposalDraft& b) { return a.own_score > b.own_score; });
}

/// The features of all proposals, with the one that depends on the others: `continued`.
std::vector<ObjectFeatures> completed_features(const std::vector<ProposalDraft>& drafts,
                                               const std::vector<double>& continued) {
  std::vector<ObjectFeatures> features;
  for (std::size_t k = 0; k < drafts.size(); ++k) {
    features.push_back(drafts[k].features);
    features.back().continued = continued[k];
  }
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
                                            const std::vector<double>& continued,
                                            const PointCloud& cloud,
                                            const ProposalOptions& options) {
  const TreeModel& alone = chosen_model(options.object_alone, object_model());
  const TreeModel& among_others = chosen_model(options.object_among_others, object_context_model());
  const std::vector<ObjectFeatures> features = completed_features(drafts, continued);
  std::vector<double> estimates, probabilities;
  for (const ObjectFeatures& own : features) estimates.push_back(estimated_probability(own, alone));
  const std::vector<ProposalContext> contexts =
      contexts_of(drafts, estimates, options.proposal_context);
  for (std::size_t k = 0; k < drafts.size(); ++k) {
    probabilities.push_back(
        combined_score(estimated_probability(features[k], contexts[k], among_others),
                       features[k].confidence, options.object_score.confidence_weight));
  }
  const std::vector<double> discounts = part_discounts(drafts, probabilities, options.continuation);
  std::vector<ObjectProposal> proposals;
  for (std::size_t k = 0; k < drafts.size(); ++k) {
    const double score = probabilities[k] * (1.0 - discounts[k]);
    proposals.push_back({object_of(std::move(drafts[k].merged), cloud, score), features[k],
                         drafts[k].own_score, estimates[k], probabilities[k], discounts[k]});
  }
  std::stable_sort(proposals.begin(), proposals.end(),
                   [](const ObjectProposal& a, const ObjectProposal& b) {
                     return a.object.score > b.object.score;
                   });
  return proposals;
}

}  // namespace

std::vector<ObjectProposal> object_proposals(const Workspace& space,
                                             const std::optional<Plane>& table,
                                             const std::vector<Hypothesis>& rotational,
                                             const std::vector<Hypothesis>& reflectional,
                                             const ProposalOptions& options) {
  const SurfaceRegions regions(space.cloud, space.edges, space.neighbors, options.surface_parts);
  const ObjectMeter meter({space.cloud, space.edges, space.field, regions, table}, options);
  const auto continuations = [&](const std::vector<ProposalDraft>& among) {
    return find_continuations(space.cloud, space.field, among, options.continuation);
  };
  std::vector<ProposalDraft> drafts;
  add_drafts(merged_hypotheses(space, rotational, reflectional, regions, options), false, meter,
             options, drafts);
  add_drafts(joined_pairs(drafts, continuations(drafts), options.merge.same_object), true, meter,
             options, drafts);
  // Joined pairs may be continued by a third proposal.
  const std::vector<double> continued = continuations(drafts).continued;
  return final_proposals(std::move(drafts), continued, space.cloud, options);
}

std::vector<SceneObject> probable_objects(const SceneProposals& proposals,
                                          const SelectionOptions& options,
                                          std::vector<Rejection>& rejected) {
  std::vector<SceneObject> objects;
  for (const ObjectProposal& proposal : proposals.objects) objects.push_back(proposal.object);
  return select_probable(std::move(objects), options, rejected);
}

}  // namespace symscene
