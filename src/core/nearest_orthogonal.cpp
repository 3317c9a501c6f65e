#include "core/nearest_orthogonal.hpp"

#include <Eigen/SVD>

namespace symscene {
namespace {

Eigen::JacobiSVD<Eigen::Matrix3d> decomposed(const Eigen::Matrix3d& matrix) {
  return Eigen::JacobiSVD<Eigen::Matrix3d>(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
}

}  // namespace

Eigen::Matrix3d nearest_orthogonal(const Eigen::Matrix3d& matrix) {
  const auto svd = decomposed(matrix);
  return svd.matrixU() * svd.matrixV().transpose();
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix) {
  const auto svd = decomposed(matrix);
  const Eigen::Matrix3d nearest = svd.matrixU() * svd.matrixV().transpose();
  const Eigen::Vector3d signs(1.0, 1.0, nearest.determinant());
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace symscene
