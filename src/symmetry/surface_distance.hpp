#pragma once

#include <vector>

#include "symscene/core/neighbors.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Distances from a surface that is given by oriented samples of even density, with a diameter of
/// about one.
class SurfaceDistance {
 public:
  /// The samples must have normals; there is at least one.
  explicit SurfaceDistance(const PointCloud& samples);

  struct Match {
    Index sample = 0;
    float distance = 0.0F;
  };
  /// The sample that is nearest to a point, and the distance from the surface there.
  Match nearest(const Eigen::Vector3f& point) const;
  /// The same for the sample that is nearest to the middle of the point's cell in a grid. Fast.
  Match coarse(const Eigen::Vector3f& point) const;

  const PointCloud& samples() const { return samples_; }

 private:
  std::size_t cell_of(const Eigen::Vector3f& point) const;
  Eigen::Vector3f center_of(std::size_t cell) const;
  void seed_cells();
  void spread(int direction);
  /// From the tangent plane of a sample, as far as it reaches sideways. [m]
  float distance(const Eigen::Vector3f& point, Index sample, float reach) const;

  const PointCloud& samples_;
  float spacing_;
  CellList cells_;
  Eigen::Vector3f low_ = Eigen::Vector3f::Zero();
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  std::vector<Index> nearest_;  ///< the sample nearest to the middle of each cell of the grid
};

}  // namespace symscene
