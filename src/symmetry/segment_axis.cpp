#include "symmetry/segment_axis.hpp"

#include "symmetry/axis_fit.hpp"
#include "symmetry/axis_quality.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

AxisJudgement judge_axis(const AxisQuality& quality, const RotationalDetectionOptions& options) {
  if (quality.symmetry_residual >= options.max_symmetry_residual)
    return {AxisOutcome::symmetry, quality.symmetry_residual, options.max_symmetry_residual};
  if (quality.perpendicularity >= options.max_perpendicularity)
    return {AxisOutcome::perpendicularity, quality.perpendicularity, options.max_perpendicularity};
  if (quality.coverage <= options.min_coverage)
    return {AxisOutcome::coverage, quality.coverage, options.min_coverage};
  if (quality.occlusion_residual >= options.max_occlusion_residual)
    return {AxisOutcome::occlusion, quality.occlusion_residual, options.max_occlusion_residual};
  return {AxisOutcome::accepted};
}

/// The points of a segment that are not on its rim, where normals are least accurate: those whose
/// neighbours that belong to the segment lie all around them.
PointIndices interior_points(const PointCloud& cloud, const PointIndices& segment,
                             const RotationalDetectionOptions& options) {
  const auto radius = static_cast<float>(options.rim_radius);
  const auto rim_offset = static_cast<float>(options.rim_offset);
  const PointCloud members = select(cloud, segment);
  const CellList cells(members.positions, radius);
  PointIndices interior;
  for (Index k = 0; k < members.size(); ++k) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    float count = 0.0F;
    const Eigen::Vector3f here = members.position(k);
    cells.for_each_within(here, radius, [&](Index j, float) {
      if (j == k) return;
      sum += members.position(j) - here;
      count += 1.0F;
    });
    if (sum.norm() < rim_offset * radius * count) interior.push_back(segment[k]);
  }
  return interior;
}

bool is_better(AxisOutcome outcome, const AxisQuality& quality, const SegmentAxis& best) {
  if (outcome != best.judgement.outcome) return outcome > best.judgement.outcome;
  const AxisQuality& other = best.candidate.quality;
  return outcome == AxisOutcome::accepted ? quality.occlusion_residual < other.occlusion_residual
                                          : quality.symmetry_residual < other.symmetry_residual;
}

}  // namespace

const char* to_string(AxisOutcome outcome) {
  switch (outcome) {
    case AxisOutcome::no_fit:
      return "no_fit";
    case AxisOutcome::symmetry:
      return "symmetry";
    case AxisOutcome::perpendicularity:
      return "perpendicularity";
    case AxisOutcome::coverage:
      return "coverage";
    case AxisOutcome::occlusion:
      return "occlusion";
    case AxisOutcome::accepted:
      return "accepted";
  }
  return "";
}

SegmentAxis segment_axis(const PointCloud& cloud, const PointIndices& segment,
                         const DistanceField& field, const std::optional<Eigen::Vector3d>& up,
                         const RotationalDetectionOptions& options) {
  std::vector<Eigen::Vector3d> directions;
  if (up) directions.push_back(*up);
  SegmentAxis best;
  const PointCloud interior = select(cloud, interior_points(cloud, segment, options));
  for (const RotationAxis& initial : initial_axes(interior, directions, options.fit)) {
    const AxisFit fit = fit_axis(interior, initial, options.fit);
    if (!is_usable(fit.status)) continue;
    const AxisQuality quality = axis_quality(interior, fit.axis, field, options);
    const AxisJudgement judgement = judge_axis(quality, options);
    if (is_better(judgement.outcome, quality, best)) best = {judgement, {fit.axis, quality, {}}};
  }
  best.candidate.support = segment;
  return best;
}

}  // namespace symscene
