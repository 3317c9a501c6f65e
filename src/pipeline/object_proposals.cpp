#include "pipeline/object_proposals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  const ObjectMeter meter(space.cloud, space.edges, space.field, proposals.table);
  const SymmetryMeter symmetry_meter(space, options);
  std::vector<ObjectProposal> objects(sets.size());
  parallel_for_each(sets.size(), [&](std::size_t k) {
    ObjectProposal& proposal = objects[k];
    proposal.object = std::move(sets[k]);
    proposal.measures = meter.measure(proposal.object.points);
    proposal.measures.seam = regions.seam(proposal.object.points);
    symmetry_meter.measure(proposal.object, proposal.measures);
    proposal.measures.confidence = proposal.object.score;  // of the cut
    proposal.object.score = object_score(proposal.measures);
  });
  std::stable_sort(objects.begin(), objects.end(),
                   [](const ObjectProposal& a, const ObjectProposal& b) {
                     return a.object.score > b.object.score;
                   });
  return objects;
}

}  // namespace symscene
