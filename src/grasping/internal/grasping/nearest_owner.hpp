#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// Tells which of several owners claims the voxel that is nearest to a voxel of a box.
class NearestOwner {
 public:
  /// Owners are numbers below `owners`.
  NearestOwner(const Eigen::Array3i& size, int owners);

  void claim(const Eigen::Array3i& voxel, int owner);

  struct Claim {
    int owner = nobody;
    int squared_distance = 0;  ///< [voxels²]
  };
  static constexpr int nobody = -1;

  /// The nearest claim of each voxel, x fastest, z slowest, and that of `nobody` without one within
  /// `radius` voxels. The lowest owner of several. Distances are Euclidean, found one axis after
  /// the other (Felzenszwalb and Huttenlocher 2012).
  std::vector<Claim> nearest(int radius) const;

 private:
  Eigen::Index row_begin(Eigen::Index y, Eigen::Index z) const {
    return (z * size_.y() + y) * size_.x();
  }
  /// The least of the values along an axis within the radius, with the square of their distance.
  Eigen::ArrayXd least_along(int axis, int radius, const Eigen::ArrayXd& values) const;

  Eigen::Array3i size_;
  double owners_;
  Eigen::ArrayXd claims_;  ///< squared distance × number of owners + owner; infinity for none
};

}  // namespace symscene
