#include "proposals/object_proposals.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/model_features.hpp"
#include "core/parallel.hpp"
#include "object_score.hpp"
#include "surface_continuation.hpp"

namespace symscene {
namespace {

/// How well the points agree with the symmetries under which they were cut out.
class SymmetryMeter {
 public:
  SymmetryMeter(const Workspace& space, const ProposalOptions& options)
      : space_(space), options_(options) {}

  void measure(const SceneObject& object, ObjectFeatures& features) const {
    features.axes = static_cast<double>(object.rotational.size());
    features.planes = std::min(static_cast<double>(object.reflectional.size()), 4.0);
    if (object.rotational.empty() && object.reflectional.empty()) return;
    const PointCloud points = select(space_.cloud, object.points);
    for (const ScoredAxis& own : object.rotational) {
      const RotationalScores scores =
          rotational_scores(points, own.axis, space_.field, options_.rotational_detection);
      features.axis_misfit = std::min(features.axis_misfit, scores.symmetry_residual);
      features.axis_occlusion = std::min(features.axis_occlusion, scores.occlusion_residual);
    }
    if (object.reflectional.empty()) return;
    const CellList cells(points.positions, cell_size);
    const PointIndices sample = evenly_spread(
        points.size(), static_cast<Index>(options_.reflectional_detection.max_points));
    for (const ScoredPlane& own : object.reflectional) {
      const ReflectionalScores scores = reflectional_scores(
          points, cells, sample, own.plane, space_.field, options_.reflectional_detection);
      features.plane_inlier = std::max(features.plane_inlier, scores.inlier_score);
      features.plane_occlusion = std::min(features.plane_occlusion, scores.occlusion_residual);
    }
  }

 private:
  static constexpr float cell_size = 0.01F;
  const Workspace& space_;
  const ProposalOptions& options_;
};

constexpr double confidence_weight = 0.6;

double score_alone(const ObjectFeatures& features, const TreeModel& model) {
  return combined_score(estimated_probability(features, model), features.confidence,
                        confidence_weight);
}

/// Measures and scores sets of points of one scene.
class ProposalMaker {
 public:
  ProposalMaker(const Workspace& space, const SceneProposals& proposals,
                const SurfaceRegions& regions, const ProposalOptions& options)
      : regions_(regions),
        meter_(space.cloud, space.edges, space.field, proposals.table),
        symmetry_meter_(space, options),
        model_(chosen_model(options.object_alone, object_model())) {}

  /// In the order given. The score of a set that is given is the confidence of its cut.
  std::vector<ObjectProposal> make(std::vector<SceneObject> sets) const {
    std::vector<ObjectProposal> made(sets.size());
    parallel_for_each(sets.size(), [&](std::size_t k) {
      ObjectProposal& proposal = made[k];
      proposal.object = std::move(sets[k]);
      proposal.features = meter_.measure(proposal.object.points);
      proposal.features.seam = regions_.seam(proposal.object.points);
      proposal.features.confidence = proposal.object.score;
      symmetry_meter_.measure(proposal.object, proposal.features);
      proposal.object.score = score_alone(proposal.features, model_);
    });
    return made;
  }

 private:
  const SurfaceRegions& regions_;
  ObjectMeter meter_;
  SymmetryMeter symmetry_meter_;
  const TreeModel& model_;
};

void sort_by_score(std::vector<ObjectProposal>& objects) {
  std::stable_sort(objects.begin(), objects.end(),
                   [](const ObjectProposal& a, const ObjectProposal& b) {
                     return a.object.score > b.object.score;
                   });
}

/// Which proposals continue one another behind what hides the space between them.
struct Continuations {
  std::vector<double> continued;  ///< of each proposal, how much the best other does
  std::vector<std::pair<std::size_t, std::size_t>>
      pairs;  ///< that do so well, the first the better
};

/// Looks at proposals that come by falling score.
Continuations find_continuations(const Workspace& space,
                                 const std::vector<ObjectProposal>& proposals,
                                 const ContinuationOptions& options) {
  const auto end = std::find_if(proposals.begin(), proposals.end(), [&](const ObjectProposal& p) {
    return p.object.score < options.min_score;
  });
  const auto count = static_cast<std::size_t>(end - proposals.begin());
  const std::size_t best = std::min(count, static_cast<std::size_t>(options.most));
  std::vector<SurfaceSample> samples(count);
  for (std::size_t k = 0; k < count; ++k)
    samples[k] = sample_surface(space.cloud, proposals[k].object.points);
  Continuations found;
  found.continued.resize(proposals.size(), 0.0);
  std::vector<std::vector<std::size_t>> partners(count);
  parallel_for_each(count, [&](std::size_t a) {
    const PointIndices& own = proposals[a].object.points;
    for (std::size_t b = 0; b < best; ++b) {
      if (a == b) continue;
      const PointIndices& other = proposals[b].object.points;
      const double value =
          continuation(samples[a], samples[b], space.field, static_cast<float>(options.reach));
      if (value <= 0.0 || 20 * intersection_size(own, other) > std::min(own.size(), other.size()))
        continue;
      found.continued[a] = std::max(found.continued[a], value);
      if (a < b && value >= options.min_continuation) partners[a].push_back(b);
    }
  });
  for (std::size_t a = 0; a < count; ++a) {
    for (const std::size_t b : partners[a]) found.pairs.emplace_back(a, b);
  }
  return found;
}

std::vector<SceneObject> joined_pairs(const Workspace& space,
                                      const std::vector<ObjectProposal>& proposals,
                                      const Continuations& continuations) {
  std::vector<SceneObject> joined;
  for (const auto& [a, b] : continuations.pairs) {
    const PointIndices &p = proposals[a].object.points, &q = proposals[b].object.points;
    SceneObject object;
    std::set_union(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(object.points));
    object.centroid = centroid(space.cloud.positions, object.points);
    joined.push_back(std::move(object));
  }
  return joined;
}

/// The scores with which objects are chosen.
void score_among_others(const ProposalOptions& options, std::vector<ObjectProposal>& proposals) {
  const TreeModel& alone = chosen_model(options.object_alone, object_model());
  const TreeModel& among_others = chosen_model(options.object_among_others, object_context_model());
  std::vector<const PointIndices*> sets;
  std::vector<double> estimates;
  for (const ObjectProposal& proposal : proposals) {
    sets.push_back(&proposal.object.points);
    estimates.push_back(estimated_probability(proposal.features, alone));
  }
  const std::vector<ProposalContext> contexts = proposal_contexts(SharedCounts(sets), estimates);
  for (std::size_t k = 0; k < proposals.size(); ++k) {
    ObjectProposal& proposal = proposals[k];
    proposal.object.score =
        combined_score(estimated_probability(proposal.features, contexts[k], among_others),
                       proposal.features.confidence, confidence_weight);
  }
}

/// Without sets that nearly equal an earlier one, of this list or of `known`.
std::vector<SceneObject> without_known(std::vector<SceneObject> sets,
                                       const std::vector<ObjectProposal>& known,
                                       double same_object) {
  std::vector<SceneObject> distinct;
  for (SceneObject& set : sets) {
    const auto repeats = [&](const SceneObject& other) {
      return is_same_set(other.points, set.points, same_object);
    };
    const bool is_known = std::any_of(
        known.begin(), known.end(), [&](const auto& proposal) { return repeats(proposal.object); });
    if (!is_known && std::none_of(distinct.begin(), distinct.end(), repeats))
      distinct.push_back(std::move(set));
  }
  return distinct;
}

/// What lies in two that continue one another is hardly an object if they look like one together.
void yield_to_joined(const std::vector<PointIndices>& joined, const ContinuationOptions& options,
                     std::vector<ObjectProposal>& proposals) {
  std::vector<double> scores;  // of what is joined
  for (const PointIndices& whole : joined) {
    const auto own = std::find_if(proposals.begin(), proposals.end(), [&](const auto& proposal) {
      return proposal.object.points == whole;
    });
    scores.push_back(own->object.score);
  }
  parallel_for_each(proposals.size(), [&](std::size_t k) {
    const PointIndices& part = proposals[k].object.points;
    double best = 0.0;
    for (std::size_t j = 0; j < joined.size(); ++j) {
      const bool is_part = part.size() < joined[j].size() &&
                           20 * intersection_size(part, joined[j]) > 19 * part.size();
      if (is_part) best = std::max(best, scores[j]);
    }
    proposals[k].object.score *= 1.0 - options.whole_belief * best;
  });
}

}  // namespace

std::vector<ObjectProposal> object_proposals(const Workspace& space,
                                             const SceneProposals& proposals,
                                             const ProposalOptions& options) {
  const SurfaceRegions regions(space.cloud, space.edges, space.neighbors, options.surface_parts);
  std::vector<RatedHypothesis> rated;
  append_rated(proposals.rotational, options.rotational_bounds, rated);
  append_rated(proposals.reflectional, options.reflectional_bounds, rated);
  std::erase_if(rated, [&](const RatedHypothesis& cut) {
    return cut.hypothesis.points.size() < static_cast<std::size_t>(options.surface_parts.min_size);
  });
  for (PointIndices& part : regions.parts()) {
    Hypothesis hypothesis;
    hypothesis.points = std::move(part);
    rated.push_back({std::move(hypothesis), 0.0});
  }
  std::vector<SceneObject> sets = merge_hypotheses(std::move(rated), space.cloud, options.merge);
  const ProposalMaker maker(space, proposals, regions, options);
  std::vector<ObjectProposal> objects = maker.make(std::move(sets));
  sort_by_score(objects);
  std::vector<ObjectProposal> joined = maker.make(without_known(
      joined_pairs(space, objects, find_continuations(space, objects, options.continuation)),
      objects, options.merge.same_object));
  std::vector<PointIndices> joined_sets;
  for (const ObjectProposal& proposal : joined) joined_sets.push_back(proposal.object.points);
  objects.insert(objects.end(), std::make_move_iterator(joined.begin()),
                 std::make_move_iterator(joined.end()));
  sort_by_score(objects);
  // What is joined may go on elsewhere, and its parts are known to go on.
  const Continuations continuations = find_continuations(space, objects, options.continuation);
  for (std::size_t k = 0; k < objects.size(); ++k)
    objects[k].features.continued = continuations.continued[k];
  score_among_others(options, objects);
  yield_to_joined(joined_sets, options.continuation, objects);
  sort_by_score(objects);
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
