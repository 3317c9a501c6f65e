#include "symmetry_fit.hpp"

#include <algorithm>

#include "symmetry/axis_quality.hpp"
#include "symmetry/plane_quality.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr float cell_size = 0.01F;  // [m]
constexpr double max_planes = 4.0;

}  // namespace

SymmetryFit symmetry_fit(const MergedHypothesis& merged, const PointCloud& cloud,
                         const DistanceField& field, const ProposalOptions& options) {
  SymmetryFit fit;
  fit.axes = static_cast<double>(merged.axes.size());
  fit.planes = std::min(static_cast<double>(merged.planes.size()), max_planes);
  if (merged.axes.empty() && merged.planes.empty()) return fit;
  const PointCloud points = select(cloud, merged.points);
  for (const ObjectAxis& own : merged.axes) {
    const AxisQuality quality = axis_quality(points, own.axis, field, options.rotational_detection);
    fit.axis_misfit = std::min(fit.axis_misfit, quality.symmetry_residual);
    fit.axis_occlusion = std::min(fit.axis_occlusion, quality.occlusion_residual);
  }
  if (merged.planes.empty()) return fit;
  const CellList cells(points.positions, cell_size);
  const PointIndices sample =
      evenly_spread(points.size(), static_cast<Index>(options.reflectional_detection.max_points));
  for (const ObjectPlane& own : merged.planes) {
    const PlaneQuality quality =
        plane_quality({points, cells}, sample, own.plane, field, options.reflectional_detection);
    fit.plane_inlier = std::max(fit.plane_inlier, quality.inlier_score);
    fit.plane_occlusion = std::min(fit.plane_occlusion, quality.occlusion_residual);
  }
  return fit;
}

}  // namespace symscene
