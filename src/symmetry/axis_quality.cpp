#include "symmetry/axis_quality.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "symmetry/point_residuals.hpp"
#include "symmetry/score_range.hpp"

namespace symscene {

double angular_coverage(const Points& points, const RotationAxis& axis) {
  constexpr int bins = 360;
  const Eigen::Matrix<double, 3, 2> across = orthonormal_complement(axis.direction);
  const Eigen::Vector3d u = across.col(0);
  const Eigen::Vector3d v = across.col(1);
  std::bitset<bins> seen;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d q = points.row(i).transpose().cast<double>() - axis.point;
    const double turn = std::atan2(v.dot(q), u.dot(q)) / (2.0 * std::numbers::pi) + 0.5;
    seen.set(std::min(static_cast<std::size_t>(turn * bins), std::size_t{bins - 1}));
  }
  if (seen.none()) return 0.0;
  int gap = 0;
  int largest_gap = 0;
  for (std::size_t bin = 0; bin < 2 * bins; ++bin) {
    gap = seen[bin % bins] ? 0 : gap + 1;
    largest_gap = std::max(largest_gap, gap);
  }
  return 1.0 - static_cast<double>(largest_gap) / bins;
}

AxisQuality axis_quality(const PointCloud& cloud, const RotationAxis& axis,
                         const DistanceField& field, const RotationalDetectionOptions& options) {
  if (cloud.empty()) return {1.0, 1.0, 0.0, 1.0};
  const AxisResiduals residuals(axis);
  const ScoreRange angles = angle_range(options);
  const ScoreRange occlusions = occlusion_range(options);
  AxisQuality quality;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f p = cloud.position(i);
    const Eigen::Vector3f n = cloud.normal(i);
    quality.symmetry_residual += double{angles(residuals.plane_angle(p, n))};  // Eq. 3.5
    quality.perpendicularity +=
        1.0 - double{residuals.axis_angle(n)} / (std::numbers::pi / 2);                   // Eq. 3.6
    quality.occlusion_residual += double{occlusions(residuals.free_distance(p, field))};  // Eq. 4.3
  }
  const auto count = static_cast<double>(cloud.size());
  quality.symmetry_residual /= count;
  quality.perpendicularity /= count;
  quality.occlusion_residual /= count;
  quality.coverage = angular_coverage(cloud.positions, axis);
  return quality;
}

}  // namespace symscene
