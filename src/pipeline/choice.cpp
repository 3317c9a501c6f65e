#include <algorithm>

#include "classes/classification_among.hpp"
#include "core/parallel.hpp"
#include "proposals/merge.hpp"
#include "proposals/object_proposals.hpp"
#include "proposals/object_score.hpp"
#include "proposals/score_effects.hpp"
#include "proposals/selection.hpp"
#include "symmetry/object_symmetry.hpp"
#include "symscene/classes/class_symmetries.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene {
namespace {

std::vector<Hypothesis> accepted(const std::vector<Hypothesis>& hypotheses,
                                 const HypothesisBounds& bounds, const std::string& kind,
                                 std::vector<Rejection>& rejected) {
  std::vector<Hypothesis> kept;
  for (const Hypothesis& hypothesis : hypotheses) {
    if (const auto rejection = judge(hypothesis, bounds, kind)) {
      rejected.push_back(*rejection);
    } else {
      kept.push_back(hypothesis);
    }
  }
  return kept;
}

/// The object of a hypothesis within the bounds, with its symmetries and their residuals.
SceneObject object_within_bounds(const MergedHypothesis& merged) {
  SceneObject object{.points = merged.points, .confidence = merged.confidence};
  for (const auto& [axis, residual] : merged.axes) object.rotational.push_back({axis, residual});
  for (const auto& [plane, residual] : merged.planes)
    object.reflectional.push_back({plane, residual});
  return object;
}

/// Section 4.3.3: hypotheses within the bounds, equal ones merged, composites of others rejected.
void choose_within_bounds(const SceneProposals& proposals, const PipelineOptions& options,
                          SegmentationResult& result) {
  const HypothesisBounds& of_axes = options.rotational_segmentation.bounds;
  const HypothesisBounds& of_planes = options.reflectional_segmentation.bounds;
  const std::vector<Hypothesis> rotational =
      accepted(proposals.rotational, of_axes, "rotational", result.rejected);
  result.rejected.insert(result.rejected.end(), proposals.rejected.begin(),
                         proposals.rejected.end());
  const std::vector<Hypothesis> reflectional =
      accepted(proposals.reflectional, of_planes, "reflectional", result.rejected);
  result.funnel.push_back({"rotational: hypotheses within the bounds", rotational.size()});
  result.funnel.push_back({"reflectional: hypotheses within the bounds", reflectional.size()});

  std::vector<RatedHypothesis> rated;
  append_rated(rotational, of_axes, rated);
  append_rated(reflectional, of_planes, rated);
  const std::vector<MergedHypothesis> distinct =
      merge_hypotheses(std::move(rated), proposals.cloud, options.merge);
  result.funnel.push_back({"distinct hypotheses", distinct.size()});
  std::vector<SelectionCandidate> candidates;
  for (const MergedHypothesis& merged : distinct)
    candidates.push_back(selection_candidate(merged, merged.confidence));
  for (const std::size_t k : select_consistent(candidates, options.selection, result.rejected))
    result.objects.push_back(object_within_bounds(distinct[k]));
}

/// The points of other objects within `margin` of the box of an object's points. [m]
PointCloud near_others(const PointCloud& cloud, const PointIndices& object, double margin) {
  const Box box = bounding_box(select(cloud, object).positions).padded(static_cast<float>(margin));
  PointIndices others;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f position = cloud.position(i);
    if ((position - box.min).minCoeff() < 0.0F || (box.max - position).minCoeff() < 0.0F) continue;
    if (!std::binary_search(object.begin(), object.end(), i)) others.push_back(i);
  }
  return select(cloud, others);
}

/// Determines the symmetry class of an object (section 4.7), and adds its symmetries to the list.
void classify_object(const SceneProposals& proposals, const PipelineOptions& options,
                     SceneObject& object) {
  if (!options.classes.enabled) return;
  const PointCloud points = select(proposals.cloud, object.points);
  constexpr double margin = 3.0;  // in spacings
  object.symmetry_class = classify_among(
      {points, options.voxel_size, object.rotational, object.reflectional, proposals.field,
       proposals.table},
      near_others(proposals.cloud, object.points, margin * options.voxel_size), options.classes);
  if (!options.classes.complete_symmetries) return;
  SymmetryLists lists =
      with_symmetries_of_class({std::move(object.rotational), std::move(object.reflectional)},
                               *object.symmetry_class, options.object_symmetry.same_plane_angle);
  object.symmetry_class = centred_on_planes(std::move(*object.symmetry_class), lists.reflectional);
  ListedSymmetries measured =
      with_measured_residuals({std::move(lists.rotational), std::move(lists.reflectional)}, points,
                              proposals.field, options.symmetry_search_options());
  object.rotational = std::move(measured.rotational);
  object.reflectional = std::move(measured.reflectional);
}

constexpr std::size_t explained_rejections = 30;

/// Rejections by score, and the proposals that they are of: those that came nearest to becoming an
/// object.
std::vector<std::pair<Rejection*, const ObjectProposal*>> nearest_rejections(
    const SceneProposals& proposals, SegmentationResult& result) {
  std::vector<std::pair<Rejection*, const ObjectProposal*>> nearest;
  for (const ObjectProposal& proposal : proposals.objects) {  // by falling score
    const auto rejection = std::find_if(
        result.rejected.begin(), result.rejected.end(), [&](const Rejection& rejected) {
          return rejected.reason == "score" && rejected.points == proposal.merged.points;
        });
    if (rejection == result.rejected.end()) continue;
    nearest.emplace_back(&*rejection, &proposal);
    if (nearest.size() == explained_rejections) break;
  }
  return nearest;
}

/// Tells what decided the scores of the objects, and of the rejected proposals that came nearest to
/// becoming one.
void explain_scores(const SceneProposals& proposals, const std::vector<std::size_t>& chosen,
                    const PipelineOptions& options, SegmentationResult& result) {
  const ProposalOptions scoring = options.proposal_options();
  const ScoreModels models{chosen_model(scoring.object_alone, object_model()),
                           chosen_model(scoring.object_among_others, object_context_model()),
                           scoring.proposal_context.own_weight};
  const ScoreInputs medians = median_inputs(proposals.objects);
  const auto rejections = nearest_rejections(proposals, result);
  parallel_for_each(chosen.size() + rejections.size(), [&](std::size_t k) {
    if (k < chosen.size()) {
      result.objects[k].score_effects =
          score_effects(proposals.objects[chosen[k]], medians, models);
    } else {
      const auto& [rejection, proposal] = rejections[k - chosen.size()];
      rejection->score_effects = score_effects(*proposal, medians, models);
    }
  });
}

/// Proposals by probability, with the symmetries estimated anew on all points of each object.
void choose_probable(const SceneProposals& proposals, const PipelineOptions& options,
                     SegmentationResult& result) {
  const SymmetrySearchOptions search = options.symmetry_search_options();
  result.rejected = proposals.rejected;
  const std::vector<std::size_t> chosen =
      probable_proposals(proposals, options.selection, result.rejected);
  result.objects.resize(chosen.size());
  parallel_for_each(chosen.size(), [&](std::size_t k) {
    const ObjectProposal& proposal = proposals.objects[chosen[k]];
    result.objects[k] = probable_object(
        proposal,
        symmetry_candidates(proposals.observed(),
                            searched_object(proposals, chosen[k], options.object_symmetry), search),
        options.object_symmetry);
    classify_object(proposals, options, result.objects[k]);
  });
  explain_scores(proposals, chosen, options, result);
}

}  // namespace

SegmentationResult choose_objects(const SceneProposals& proposals, const PipelineOptions& options) {
  SegmentationResult result;
  result.cloud = proposals.cloud;
  result.table = proposals.table;
  result.funnel = proposals.funnel;
  result.warnings = proposals.warnings;
  if (options.selection.by_score) {
    choose_probable(proposals, options, result);
  } else {
    choose_within_bounds(proposals, options, result);
  }
  result.funnel.push_back({"objects", result.objects.size()});
  return result;
}

}  // namespace symscene
