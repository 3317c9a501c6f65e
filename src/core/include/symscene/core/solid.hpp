#pragma once

#include <Eigen/Core>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// A body of uniform density, in the frame of its mesh.
struct SolidProperties {
  double volume = 0.0;                                       ///< [m³]
  Eigen::Vector3d centre_of_mass = Eigen::Vector3d::Zero();  ///< [m]
  /// Unit vectors as columns, right-handed, by ascending moment of inertia: the longest direction
  /// first.
  Eigen::Matrix3d principal_axes = Eigen::Matrix3d::Identity();
  /// Moments of inertia about these axes through the centre of mass, divided by the mass. [m²]
  Eigen::Vector3d principal_moments = Eigen::Vector3d::Zero();
};

/// The exact integrals over the inside of a closed mesh, as sums over the tetrahedra between its
/// triangles and a point (Mirtich 1996 has the same integrals over projections). A mesh that
/// encloses no volume has all properties zero and the coordinate axes.
SolidProperties solid_properties(const TriangleMesh& mesh);

}  // namespace symscene
