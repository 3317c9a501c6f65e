#include "symscene/core/solid.hpp"

#include <limits>

#include <Eigen/Dense>

namespace symscene {
namespace {

/// Sums over the tetrahedra between a mesh's triangles and a reference point.
struct TetrahedronSums {
  double volume = 0.0;                               ///< ∫ dV
  Eigen::Vector3d first = Eigen::Vector3d::Zero();   ///< ∫ x dV
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< ∫ x xᵀ dV

  void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double six_volumes = a.dot(b.cross(c));
    const Eigen::Vector3d sum = a + b + c;
    volume += six_volumes / 6.0;
    first += six_volumes / 24.0 * sum;
    second += six_volumes / 120.0 *
              (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
};

TetrahedronSums sums_about(const TriangleMesh& mesh, const Eigen::Vector3d& reference) {
  TetrahedronSums sums;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](Eigen::Index k) -> Eigen::Vector3d {
      return mesh.vertices.row(mesh.triangles(t, k)).transpose().cast<double>() - reference;
    };
    sums.add(corner(0), corner(1), corner(2));
  }
  return sums;
}

}  // namespace

SolidProperties solid_properties(const TriangleMesh& mesh) {
  if (mesh.triangles.rows() == 0) return {};
  // Near the mesh, so that far from the origin the sums do not cancel out.
  const Eigen::Vector3d reference = mesh.vertices.colwise().mean().transpose().cast<double>();
  const TetrahedronSums sums = sums_about(mesh, reference);
  if (!(sums.volume > std::numeric_limits<double>::min())) return {};
  const Eigen::Vector3d centre = sums.first / sums.volume;
  const Eigen::Matrix3d covariance = sums.second / sums.volume - centre * centre.transpose();
  const Eigen::Matrix3d inertia =
      covariance.trace() * Eigen::Matrix3d::Identity() - covariance;  // per mass
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  SolidProperties solid{sums.volume, reference + centre, solver.eigenvectors(),
                        solver.eigenvalues()};
  if (solid.principal_axes.determinant() < 0.0) solid.principal_axes.col(2) *= -1.0;
  return solid;
}

}  // namespace symscene
