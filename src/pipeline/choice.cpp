#include "core/parallel.hpp"
#include "proposals/merge.hpp"
#include "proposals/object_proposals.hpp"
#include "proposals/selection.hpp"
#include "symmetry/object_symmetry.hpp"
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
  for (MergedHypothesis& merged :
       merge_hypotheses(std::move(rated), proposals.cloud, options.merge)) {
    const double score = merged.confidence;
    result.objects.push_back(object_of(std::move(merged), proposals.cloud, score));
  }
  result.funnel.push_back({"distinct hypotheses", result.objects.size()});
  result.objects = select_consistent(std::move(result.objects), options.selection, result.rejected);
}

/// Proposals by probability, with the symmetries estimated anew on all points of each object.
void choose_probable(const SceneProposals& proposals, const PipelineOptions& options,
                     SegmentationResult& result) {
  const SymmetrySearchOptions search = options.symmetry_search_options();
  result.rejected = proposals.rejected;
  result.objects = probable_objects(proposals, options.selection, result.rejected);
  parallel_for_each(result.objects.size(), [&](std::size_t k) {
    SceneObject& object = result.objects[k];
    ListedSymmetries listed = list_symmetries(
        symmetry_candidates(proposals.observed(), object, search), options.object_symmetry);
    object.rotational = std::move(listed.rotational);
    object.reflectional = std::move(listed.reflectional);
  });
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
