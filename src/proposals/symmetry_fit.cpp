#include "symmetry_fit.hpp"

#include <algorithm>

#include "symmetry/reflectional_scores.hpp"
#include "symmetry/rotational_scores.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr float cell_size = 0.01F;  // [m]
constexpr double max_planes = 4.0;

}  // namespace

SymmetryFit symmetry_fit(const SceneObject& object, const PointCloud& cloud,
                         const DistanceField& field, const ProposalOptions& options) {
  SymmetryFit fit;
  fit.axes = static_cast<double>(object.rotational.size());
  fit.planes = std::min(static_cast<double>(object.reflectional.size()), max_planes);
  if (object.rotational.empty() && object.reflectional.empty()) return fit;
  const PointCloud points = select(cloud, object.points);
  for (const ScoredAxis& own : object.rotational) {
    const RotationalScores scores =
        rotational_scores(points, own.axis, field, options.rotational_detection);
    fit.axis_misfit = std::min(fit.axis_misfit, scores.symmetry_residual);
    fit.axis_occlusion = std::min(fit.axis_occlusion, scores.occlusion_residual);
  }
  if (object.reflectional.empty()) return fit;
  const CellList cells(points.positions, cell_size);
  const PointIndices sample =
      evenly_spread(points.size(), static_cast<Index>(options.reflectional_detection.max_points));
  for (const ScoredPlane& own : object.reflectional) {
    const ReflectionalScores scores = reflectional_scores({points, cells}, sample, own.plane, field,
                                                          options.reflectional_detection);
    fit.plane_inlier = std::max(fit.plane_inlier, scores.inlier_score);
    fit.plane_occlusion = std::min(fit.plane_occlusion, scores.occlusion_residual);
  }
  return fit;
}

}  // namespace symscene
