#pragma once

#include <array>
#include <optional>

#include "symmetry/plane_fit.hpp"

namespace symscene {

/// Symmetries that share one orthonormal frame.
struct SymmetryFrame {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< [m]
  std::array<bool, 3> mirrors{};                     ///< planes through the centre, by their normal
  bool rotates = false;                              ///< about the third axis
  double residual = 0.0;  ///< root mean square distance of matched images [m]

  ReflectionPlane plane(int axis) const { return {center, axes.col(axis)}; }
};

/// A right-handed orthonormal frame whose third column is a direction.
Eigen::Matrix3d frame_about(const Eigen::Vector3d& direction);

/// The frame near `initial` under which the images of points lie on the surface (Eq. 3.7) and
/// normals lie in planes through the axis (Eq. 3.4), by Gauss-Newton steps in the three turns and
/// three shifts of the frame. `spacing` is that of the points. [m]
SymmetryFrame fit_frame(const IndexedCloud& cloud, SymmetryFrame initial, double spacing);

}  // namespace symscene
