#pragma once

#include <Eigen/Core>

namespace symscene {

/// The orthogonal matrix nearest to `matrix` in the Frobenius norm (polar decomposition); it keeps
/// the sign of the determinant.
Eigen::Matrix3d nearest_orthogonal(const Eigen::Matrix3d& matrix);

/// The rotation nearest to `matrix` in the Frobenius norm.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix);

}  // namespace symscene
