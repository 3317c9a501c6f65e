#include "proposals/object_proposals.hpp"

#include <algorithm>
#include <iterator>
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

/// The hypotheses of both streams and the parts of the surface, merged. The score of an object is
/// the confidence of its best hypothesis.
std::vector<SceneObject> merged_candidates(const Workspace& space, const SceneProposals& proposals,
                                           const SurfaceRegions& regions,
                                           const ProposalOptions& options) {
  std::vector<RatedHypothesis> rated;
  append_rated(proposals.rotational, options.rotational_bounds, rated);
  append_rated(proposals.reflectional, options.reflectional_bounds, rated);
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

/// Proposals of objects whose score is the confidence of their best hypothesis, in the same order,
/// with features and scores that do not depend on other proposals.
std::vector<ObjectProposal> measured(std::vector<SceneObject> objects, const ObjectMeter& meter,
                                     const ProposalOptions& options) {
  const TreeModel& model = chosen_model(options.object_alone, object_model());
  const double weight = options.object_score.confidence_weight;
  std::vector<ObjectProposal> proposals(objects.size());
  parallel_for_each(objects.size(), [&](std::size_t k) {
    ObjectProposal& proposal = proposals[k];
    proposal.object = std::move(objects[k]);
    proposal.cut_confidence = std::exchange(proposal.object.score, 0.0);
    proposal.features = meter.measure(proposal.object, proposal.cut_confidence);
    proposal.estimate = estimated_probability(proposal.features, model);
    proposal.own_score = combined_score(proposal.estimate, proposal.cut_confidence, weight);
  });
  return proposals;
}

void sort_by_own_score(std::vector<ObjectProposal>& proposals) {
  std::stable_sort(
      proposals.begin(), proposals.end(),
      [](const ObjectProposal& a, const ObjectProposal& b) { return a.own_score > b.own_score; });
}

/// Adds the one feature that depends on other proposals, and estimates anew with it.
void complete_features(const std::vector<double>& continued, const ProposalOptions& options,
                       std::vector<ObjectProposal>& proposals) {
  const TreeModel& model = chosen_model(options.object_alone, object_model());
  for (std::size_t k = 0; k < proposals.size(); ++k) {
    proposals[k].features.continued = continued[k];
    proposals[k].estimate = estimated_probability(proposals[k].features, model);
  }
}

/// Sets `probability` from the features and the relations between the proposals.
void score_among_others(const ProposalOptions& options, std::vector<ObjectProposal>& proposals) {
  const TreeModel& model = chosen_model(options.object_among_others, object_context_model());
  std::vector<const PointIndices*> points;
  std::vector<double> estimates;
  for (const ObjectProposal& proposal : proposals) {
    points.push_back(&proposal.object.points);
    estimates.push_back(proposal.estimate);
  }
  const std::vector<ProposalContext> contexts =
      proposal_contexts(SharedCounts(points, options.proposal_context), estimates);
  for (std::size_t k = 0; k < proposals.size(); ++k) {
    ObjectProposal& proposal = proposals[k];
    proposal.probability =
        combined_score(estimated_probability(proposal.features, contexts[k], model),
                       proposal.cut_confidence, options.object_score.confidence_weight);
  }
}

void sort_by_final_score(std::vector<ObjectProposal>& proposals) {
  for (ObjectProposal& proposal : proposals)
    proposal.object.score = proposal.probability * (1.0 - proposal.discount);
  std::stable_sort(proposals.begin(), proposals.end(),
                   [](const ObjectProposal& a, const ObjectProposal& b) {
                     return a.object.score > b.object.score;
                   });
}

}  // namespace

std::vector<ObjectProposal> object_proposals(const Workspace& space,
                                             const SceneProposals& proposals,
                                             const ProposalOptions& options) {
  const SurfaceRegions regions(space.cloud, space.edges, space.neighbors, options.surface_parts);
  const ObjectMeter meter({space.cloud, space.edges, space.field, regions, proposals.table},
                          options);
  const auto continuations = [&](const std::vector<ObjectProposal>& among) {
    return find_continuations(space.cloud, space.field, among, options.continuation);
  };
  std::vector<ObjectProposal> objects =
      measured(merged_candidates(space, proposals, regions, options), meter, options);
  sort_by_own_score(objects);
  std::vector<ObjectProposal> joined = measured(
      joined_pairs(space.cloud, objects, continuations(objects), options.merge.same_object), meter,
      options);
  std::vector<PointIndices> joined_points;
  for (const ObjectProposal& pair : joined) joined_points.push_back(pair.object.points);
  std::move(joined.begin(), joined.end(), std::back_inserter(objects));
  sort_by_own_score(objects);
  // Joined pairs may be continued by a third proposal.
  complete_features(continuations(objects).continued, options, objects);
  score_among_others(options, objects);
  discount_parts(joined_points, options.continuation, objects);
  sort_by_final_score(objects);
  return objects;
}

std::vector<SceneObject> probable_objects(const SceneProposals& proposals,
                                          const SelectionOptions& options,
                                          std::vector<Rejection>& rejected) {
  std::vector<SceneObject> objects;
  for (const ObjectProposal& proposal : proposals.objects) objects.push_back(proposal.object);
  return select_probable(std::move(objects), options, rejected);
}

}  // namespace symscene
