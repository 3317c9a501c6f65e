#pragma once

#include <vector>

#include <Eigen/Core>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Points of an object in double precision, evenly spread over the cloud.
struct FitSamples {
  std::vector<Eigen::Vector3d> positions;  ///< [m]
  std::vector<Eigen::Vector3d> normals;    ///< unit vectors
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double diagonal = 0.0;  ///< of the box along the principal axes [m]
  double thinning = 1.0;  ///< points of the cloud per sample

  std::size_t size() const { return positions.size(); }
};

/// At most `count` of the points with a unit normal.
FitSamples fit_samples(const PointCloud& cloud, int count);

}  // namespace symscene
