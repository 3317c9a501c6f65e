#include "fit_samples.hpp"

#include <algorithm>

namespace symscene {

FitSamples fit_samples(const PointCloud& cloud, int count) {
  FitSamples samples;
  const PointIndices oriented = oriented_points(cloud);
  const auto most = static_cast<Index>(oriented.size());
  for (const Index k : evenly_spread(most, static_cast<Index>(count))) {
    samples.positions.push_back(cloud.position(oriented[k]).cast<double>());
    samples.normals.push_back(cloud.normal(oriented[k]).cast<double>().normalized());
  }
  if (samples.positions.empty()) return samples;
  samples.thinning = static_cast<double>(most) / static_cast<double>(samples.size());
  samples.center = centroid(cloud.positions);
  const Eigen::Matrix3d axes = principal_axes(cloud.positions);
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e30), high = -low;
  for (const Eigen::Vector3d& p : samples.positions) {
    const Eigen::Vector3d local = axes.transpose() * (p - samples.center);
    low = low.cwiseMin(local);
    high = high.cwiseMax(local);
  }
  samples.diagonal = (high - low).norm();
  return samples;
}

}  // namespace symscene
