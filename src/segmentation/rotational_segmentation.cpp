#include "symscene/segmentation/rotational_segmentation.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "graph_cut.hpp"
#include "labeling.hpp"
#include "neighborhood.hpp"
#include "symmetry/axis_fit.hpp"
#include "symmetry/axis_quality.hpp"
#include "symmetry/point_residuals.hpp"
#include "symmetry/score_range.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

class RotationalCutter {
 public:
  RotationalCutter(const ObservedSurface& surface, const RotationalDetectionOptions& detection,
                   const RotationalSegmentationOptions& options)
      : cloud_(surface.cloud),
        scaled_edges_(surface.edges),
        field_(surface.field),
        detection_(detection),
        options_(options) {
    for (WeightedEdge& edge : scaled_edges_) edge.weight *= static_cast<float>(options.edge_factor);
  }

  Hypothesis segment(const RotationAxis& proposed) const {
    const RotationAxis axis = refitted(proposed, cut(proposed));
    const std::vector<std::uint8_t> is_object = cut(axis);
    Hypothesis hypothesis;
    hypothesis.points = object_nodes(is_object);
    const AxisQuality quality =
        axis_quality(select(cloud_, hypothesis.points), axis, field_, detection_);
    hypothesis.residuals = {quality.symmetry_residual, quality.occlusion_residual,
                            smoothness(is_object, scaled_edges_)};
    hypothesis.axis = axis;
    return hypothesis;
  }

 private:
  /// Eqs. 4.4 and 4.5. A normal parallel to the axis agrees with any parallel axis: the weight of
  /// the evidence falls to zero there.
  Affinity affinity(const AxisResiduals& residuals, Index i) const {
    const Eigen::Vector3f p = cloud_.position(i);
    const Eigen::Vector3f n = cloud_.normal(i);
    const float symmetry = angle_range(options_)(residuals.plane_angle(p, n));
    const float occlusion = occlusion_range(options_)(residuals.free_distance(p, field_));
    const float weight =
        ramp(residuals.axis_angle(n), 0.0F, static_cast<float>(options_.full_weight_angle));
    return {(1.0F - symmetry) * (1.0F - occlusion) * weight,
            static_cast<float>(options_.background_weight) * (symmetry * weight + occlusion)};
  }

  std::vector<std::uint8_t> cut(const RotationAxis& axis) const {
    const AxisResiduals residuals(axis);
    std::vector<Affinity> affinities(cloud_.size());
    for (Index i = 0; i < cloud_.size(); ++i) affinities[i] = affinity(residuals, i);
    std::vector<std::uint8_t> is_object = cut_graph(affinities, scaled_edges_).is_object;
    drop_small_components(is_object, scaled_edges_, options_.min_component);
    return is_object;
  }

  RotationAxis refitted(const RotationAxis& axis,
                        const std::vector<std::uint8_t>& is_object) const {
    const AxisFit fit = fit_axis(select(cloud_, object_nodes(is_object)), axis, detection_.fit);
    return is_usable(fit.status) &&
                   line_angle(fit.axis.direction, axis.direction) <= options_.max_refinement
               ? fit.axis
               : axis;
  }

  const PointCloud& cloud_;
  std::vector<WeightedEdge> scaled_edges_;
  const DistanceField& field_;
  const RotationalDetectionOptions& detection_;
  const RotationalSegmentationOptions& options_;
};

/// What an axis cuts out of a part of the surface; indices into the whole.
Hypothesis segment_part(const SurfacePart& part, const RotationAxis& axis,
                        const DistanceField& field, const RotationalDetectionOptions& detection,
                        const RotationalSegmentationOptions& options) {
  const RotationalCutter cutter({part.cloud, part.edges, field}, detection, options);
  Hypothesis hypothesis = cutter.segment(axis);
  hypothesis.points = part.in_whole(hypothesis.points);
  return hypothesis;
}

}  // namespace

void RotationalSegmentationOptions::validate() const {
  check_fields(*this);
  require_score_ranges(*this);
}

std::vector<Hypothesis> segment_rotational(const ObservedSurface& surface,
                                           const std::vector<RotationalCandidate>& candidates,
                                           const RotationalDetectionOptions& detection,
                                           const RotationalSegmentationOptions& options) {
  options.validate();
  const Neighborhoods neighborhoods(surface, options.neighborhood);
  const RotationalCutter whole(surface, detection, options);
  std::vector<Hypothesis> hypotheses(candidates.size());
  parallel_for_each(candidates.size(), [&](std::size_t c) {
    const auto part = neighborhoods.around(candidates[c].support);
    hypotheses[c] = part
                        ? segment_part(*part, candidates[c].axis, surface.field, detection, options)
                        : whole.segment(candidates[c].axis);
  });
  return hypotheses;
}

}  // namespace symscene
