#include "symmetry/axis_features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sphere_fit.hpp"

namespace symscene {
namespace {

/// Cylindrical coordinates of points about an axis. [m]
struct Profile {
  std::vector<double> heights, radii;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Profile profile_of(const PointCloud& points, const RotationAxis& axis) {
  Profile profile;
  for (Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = points.position(i).cast<double>();
    const double height = axis.direction.dot(p - axis.point);
    profile.heights.push_back(height);
    profile.radii.push_back(axis.distance(p));
    profile.low = std::min(profile.low, height);
    profile.high = std::max(profile.high, height);
  }
  return profile;
}

/// The mean difference of radii from the mean of their ring. Rings across flat ends span many
/// radii, so that only points that face away from the axis count. [m]
double mean_residual(const PointCloud& points, const RotationAxis& axis, const Profile& profile,
                     const AxisFeatureOptions& options) {
  const double ring = options.ring_height;
  const auto rings = static_cast<std::size_t>((profile.high - profile.low) / ring) + 1;
  std::vector<double> sums(rings), counts(rings);
  const auto ring_of = [&](std::size_t i) {
    return std::min(rings - 1, static_cast<std::size_t>((profile.heights[i] - profile.low) / ring));
  };
  const auto faces_away = [&](std::size_t i) {
    return std::abs(points.normal(static_cast<Index>(i)).cast<double>().dot(axis.direction)) <
           options.max_side_cosine;
  };
  for (std::size_t i = 0; i < profile.radii.size(); ++i) {
    if (!faces_away(i)) continue;
    sums[ring_of(i)] += profile.radii[i];
    counts[ring_of(i)] += 1.0;
  }
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < profile.radii.size(); ++i) {
    if (!faces_away(i)) continue;
    sum += std::abs(profile.radii[i] - sums[ring_of(i)] / counts[ring_of(i)]);
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

AxisFeatures axis_features(const PointCloud& points, const RotationAxis& axis,
                           const AxisQuality& quality, const std::optional<Plane>& table,
                           const AxisFeatureOptions& options) {
  AxisFeatures m;
  m.symmetry_residual = quality.symmetry_residual;
  m.perpendicularity = quality.perpendicularity;
  m.coverage = quality.coverage;
  m.occlusion_residual = quality.occlusion_residual;
  const Profile profile = profile_of(points, axis);
  m.residual = mean_residual(points, axis, profile, options);
  m.height = profile.high - profile.low;
  m.radius = *std::max_element(profile.radii.begin(), profile.radii.end());
  m.off_centre = m.radius > 0.0 ? axis.distance(centroid(points.positions)) / m.radius : 0.0;
  const Eigen::ArrayXd cosines =
      (points.normals * axis.direction.cast<float>()).cwiseAbs().cast<double>().array();
  const auto count = static_cast<double>(points.size());
  m.across = static_cast<double>((cosines < options.max_across_cosine).count()) / count;
  m.along = static_cast<double>((cosines > options.min_along_cosine).count()) / count;
  m.roundness = distance_off_sphere(points.positions);
  m.upright = table ? std::abs(table->normal.dot(axis.direction)) : -1.0;
  m.size = std::log(count);
  return m;
}

}  // namespace symscene
