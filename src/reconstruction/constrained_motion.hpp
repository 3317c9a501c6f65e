#pragma once

#include <string>
#include <vector>

#include "core/twist.hpp"

namespace symscene {

/// A basis of motions of comparable size, as a matrix to twists of the camera's frame: rotations
/// are about the centre of the scene, (0, 0, range), and scaled to the displacement at its border.
Matrix6d comparable_motions(double range);

/// The motions that a surface constrains (Zhang and Singh 2016): eigenvectors of the normal
/// equations in the basis of comparable motions.
struct ConstrainedMotions {
  Matrix6d to_twist;
  Matrix6d motions;  ///< orthonormal columns in the comparable basis, the least constrained first
  int free = 0;      ///< number of unconstrained motions: the first columns

  /// `weight` is the sum of the weights in H. Motions whose eigenvalue per weight is below
  /// `degenerate_ratio` are unconstrained.
  ConstrainedMotions(const Matrix6d& H, double weight, const Matrix6d& comparable,
                     double degenerate_ratio);

  /// The solution of H ξ = b among the constrained motions.
  Vector6d solve(const Matrix6d& H, const Vector6d& b) const;

  /// Names of the unconstrained motions by the camera's axes, e.g. "rotation about x with
  /// translation along y".
  std::vector<std::string> names_of_free() const;
};

}  // namespace symscene
