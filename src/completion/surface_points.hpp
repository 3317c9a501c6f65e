#pragma once

#include <vector>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// The points of an object that have a normal: the observed ones, then their images.
struct SurfacePoints {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;  ///< unit vectors
  std::size_t observed = 0;              ///< number of observed points

  std::size_t size() const { return positions.size(); }
  bool is_observed(std::size_t i) const { return i < observed; }
};

SurfacePoints surface_points(const PointCloud& observed, const PointCloud& added);

}  // namespace symscene
