#include "pipeline/object_proposals.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "pipeline/continuation.hpp"
#include "symscene/core/parallel.hpp"
#include "symscene/pipeline/object_score.hpp"

namespace symscene {
namespace {

void append(const std::vector<Hypothesis>& cuts, const HypothesisBounds& bounds,
            std::size_t min_size, std::vector<RatedHypothesis>& rated) {
  for (const Hypothesis& cut : cuts) {
    if (cut.points.size() >= min_size) rated.push_back({cut, confidence(cut.scores, bounds)});
  }
}

/// How well the points agree with the symmetries under which they were cut out.
class SymmetryMeter {
 public:
  SymmetryMeter(const Workspace& space, const PipelineOptions& options)
      : space_(space), options_(options) {}

  void measure(const SceneObject& object, ObjectMeasures& measures) const {
    measures.axes = static_cast<double>(object.rotational.size());
    measures.planes = std::min(static_cast<double>(object.reflectional.size()), 4.0);
    if (object.rotational.empty() && object.reflectional.empty()) return;
    const PointCloud points = select(space_.cloud, object.points);
    for (const ScoredAxis& own : object.rotational) {
      const RotationalScores scores =
          rotational_scores(points, own.axis, space_.field, options_.rotational_detection);
      measures.axis_misfit = std::min(measures.axis_misfit, scores.symmetry);
      measures.axis_occlusion = std::min(measures.axis_occlusion, scores.occlusion);
    }
    if (object.reflectional.empty()) return;
    const CellList cells(points.positions, cell_size);
    const PointIndices sample = evenly_spread(
        points.size(), static_cast<Index>(options_.reflectional_detection.max_points));
    for (const ScoredPlane& own : object.reflectional) {
      const ReflectionalScores scores = reflectional_scores(
          points, cells, sample, own.plane, space_.field, options_.reflectional_detection);
      measures.plane_inlier = std::max(measures.plane_inlier, scores.inlier);
      measures.plane_occlusion = std::min(measures.plane_occlusion, scores.occlusion);
    }
  }

 private:
  static constexpr float cell_size = 0.01F;
  const Workspace& space_;
  const PipelineOptions& options_;
};

/// Measures and scores sets of points of one scene.
class ProposalMaker {
 public:
  ProposalMaker(const Workspace& space, const SceneProposals& proposals,
                const SurfaceRegions& regions, const PipelineOptions& options)
      : regions_(regions),
        meter_(space.cloud, space.edges, space.field, proposals.table),
        symmetry_meter_(space, options) {}

  /// By falling score. The score of a set that is given is the confidence of its cut.
  std::vector<ObjectProposal> make(std::vector<SceneObject> sets) const {
    std::vector<ObjectProposal> made(sets.size());
    parallel_for_each(sets.size(), [&](std::size_t k) {
      ObjectProposal& proposal = made[k];
      proposal.object = std::move(sets[k]);
      proposal.measures = meter_.measure(proposal.object.points);
      proposal.measures.seam = regions_.seam(proposal.object.points);
      proposal.measures.confidence = proposal.object.score;
      symmetry_meter_.measure(proposal.object, proposal.measures);
      proposal.object.score = object_score(proposal.measures);
    });
    return made;
  }

 private:
  const SurfaceRegions& regions_;
  ObjectMeter meter_;
  SymmetryMeter symmetry_meter_;
};

void sort_by_score(std::vector<ObjectProposal>& objects) {
  std::stable_sort(objects.begin(), objects.end(),
                   [](const ObjectProposal& a, const ObjectProposal& b) {
                     return a.object.score > b.object.score;
                   });
}

/// Pairs of proposals that continue one another behind what hides the space between them.
class Continuations {
 public:
  Continuations(const Workspace& space, const ContinuationOptions& options)
      : space_(space), options_(options) {}

  /// Sets how much each of the proposals, which come by falling score, is continued by the best of
  /// them. Joined pairs that continue each other well are sets of their own.
  std::vector<SceneObject> join(std::vector<ObjectProposal>& proposals) const {
    const auto count = static_cast<std::size_t>(
        std::find_if(proposals.begin(), proposals.end(),
                     [&](const auto& p) { return p.object.score < options_.min_score; }) -
        proposals.begin());
    const std::size_t best = std::min(count, static_cast<std::size_t>(options_.most));
    std::vector<SurfaceSample> samples(count);
    for (std::size_t k = 0; k < count; ++k)
      samples[k] = sample_surface(space_.cloud, proposals[k].object.points);
    std::vector<std::vector<SceneObject>> joined(count);
    parallel_for_each(count, [&](std::size_t a) {
      const PointIndices& own = proposals[a].object.points;
      double& continued = proposals[a].measures.continued;
      continued = 0.0;
      for (std::size_t b = 0; b < best; ++b) {
        if (a == b) continue;
        const PointIndices& other = proposals[b].object.points;
        const double value =
            continuation(samples[a], samples[b], space_.field, static_cast<float>(options_.reach));
        if (value <= 0.0 || 20 * intersection_size(own, other) > std::min(own.size(), other.size()))
          continue;
        continued = std::max(continued, value);
        if (a < b && value >= options_.min_continuation) joined[a].push_back(join_two(own, other));
      }
    });
    std::vector<SceneObject> all;
    for (std::vector<SceneObject>& part : joined)
      std::move(part.begin(), part.end(), std::back_inserter(all));
    return all;
  }

 private:
  SceneObject join_two(const PointIndices& a, const PointIndices& b) const {
    SceneObject object;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(object.points));
    object.centroid = centroid(space_.cloud.positions, object.points);
    return object;
  }

  const Workspace& space_;
  const ContinuationOptions& options_;
};

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
  std::vector<double> best(proposals.size(), 0.0);
  for (const PointIndices& whole : joined) {
    const auto own = std::find_if(proposals.begin(), proposals.end(), [&](const auto& proposal) {
      return proposal.object.points == whole;
    });
    for (std::size_t k = 0; k < proposals.size(); ++k) {
      const PointIndices& part = proposals[k].object.points;
      const bool is_part =
          part.size() < whole.size() && 20 * intersection_size(part, whole) > 19 * part.size();
      if (is_part) best[k] = std::max(best[k], own->object.score);
    }
  }
  for (std::size_t k = 0; k < proposals.size(); ++k)
    proposals[k].object.score *= 1.0 - options.whole_belief * best[k];
}

}  // namespace

std::vector<ObjectProposal> object_proposals(const Workspace& space,
                                             const SceneProposals& proposals,
                                             const PipelineOptions& options) {
  const auto radius = static_cast<float>(options.voxel_size * std::sqrt(3.0));
  const SurfaceRegions regions(space.cloud, space.edges,
                               radius_neighbors(space.cloud.positions, radius),
                               options.surface_parts);
  const auto min_size = static_cast<std::size_t>(options.surface_parts.min_size);
  std::vector<RatedHypothesis> rated;
  append(proposals.rotational, options.rotational_segmentation.bounds, min_size, rated);
  append(proposals.reflectional, options.reflectional_segmentation.bounds, min_size, rated);
  for (PointIndices& part : regions.parts()) {
    Hypothesis hypothesis;
    hypothesis.points = std::move(part);
    rated.push_back({std::move(hypothesis), 0.0});
  }
  std::vector<SceneObject> sets = merge_hypotheses(std::move(rated), space.cloud, options.merge);
  const ProposalMaker maker(space, proposals, regions, options);
  std::vector<ObjectProposal> objects = maker.make(std::move(sets));
  sort_by_score(objects);
  const Continuations continuations(space, options.continuation);
  std::vector<ObjectProposal> joined =
      maker.make(without_known(continuations.join(objects), objects, options.merge.same_object));
  std::vector<PointIndices> joined_sets;
  for (const ObjectProposal& proposal : joined) joined_sets.push_back(proposal.object.points);
  objects.insert(objects.end(), std::make_move_iterator(joined.begin()),
                 std::make_move_iterator(joined.end()));
  sort_by_score(objects);
  // What is joined may go on elsewhere, and its parts are known to go on.
  std::ignore = continuations.join(objects);
  for (ObjectProposal& proposal : objects) proposal.object.score = object_score(proposal.measures);
  yield_to_joined(joined_sets, options.continuation, objects);
  sort_by_score(objects);
  return objects;
}

}  // namespace symscene
