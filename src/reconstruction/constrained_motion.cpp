#include "constrained_motion.hpp"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace symscene {
namespace {

constexpr double radius_of_range = 0.3;  ///< radius of the scene over its distance
constexpr double named_share = 0.4;      ///< component from which an axis is part of a name

std::string name_of(const Vector6d& direction) {
  constexpr const char* names[6] = {"rotation about x",    "rotation about y",
                                    "rotation about z",    "translation along x",
                                    "translation along y", "translation along z"};
  std::string name;
  for (int a = 0; a < 6; ++a) {
    if (std::abs(direction[a]) < named_share) continue;
    name += (name.empty() ? "" : " with ") + std::string(names[a]);
  }
  return name;
}

}  // namespace

Matrix6d comparable_motions(double range) {
  const double radius = radius_of_range * range;
  const Eigen::Vector3d center(0, 0, range);
  Matrix6d to_twist = Matrix6d::Identity();
  for (int a = 0; a < 3; ++a) {
    const Eigen::Vector3d omega = Eigen::Vector3d::Unit(a) / radius;
    to_twist.col(a).head<3>() = omega;
    to_twist.col(a).tail<3>() = -omega.cross(center);
  }
  return to_twist;
}

ConstrainedMotions::ConstrainedMotions(const Matrix6d& H, double weight, const Matrix6d& comparable,
                                       double degenerate_ratio)
    : to_twist(comparable) {
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(to_twist.transpose() * H * to_twist /
                                                       weight);
  motions = solver.eigenvectors();
  free = static_cast<int>((solver.eigenvalues().array() < degenerate_ratio).count());
}

Vector6d ConstrainedMotions::solve(const Matrix6d& H, const Vector6d& b) const {
  if (free == 6) return Vector6d::Zero();
  const Eigen::MatrixXd basis = to_twist * motions.rightCols(6 - free);
  return basis * (basis.transpose() * H * basis).ldlt().solve(basis.transpose() * b);
}

std::vector<std::string> ConstrainedMotions::names_of_free() const {
  // Projections of the camera's own motions onto the free subspace, the largest first.
  Matrix6d projection = motions.leftCols(free) * motions.leftCols(free).transpose();
  std::vector<std::string> names;
  for (int k = 0; k < free; ++k) {
    int nearest = 0;
    const double length = std::sqrt(projection.diagonal().maxCoeff(&nearest));
    const Vector6d direction = projection.col(nearest) / length;
    projection -= direction * direction.transpose();
    names.push_back(name_of(direction));
  }
  return names;
}

}  // namespace symscene
