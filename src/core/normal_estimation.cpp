#include "symscene/core/normal_estimation.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "core/parallel.hpp"
#include "core/sign_spreading.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

/// The normal, of either orientation, of the plane fitted to a point and its neighbours; zero if
/// they do not span a plane.
Eigen::Vector3f tangent_plane_normal(const Points& points, Index i,
                                     std::span<const Index> neighbors) {
  if (neighbors.size() < 3) return Eigen::Vector3f::Zero();
  const Eigen::Vector3d origin = points.row(i).transpose().cast<double>();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Index j : neighbors) {
    const Eigen::Vector3d offset = points.row(j).transpose().cast<double>() - origin;
    sum += offset;
    scatter += offset * offset.transpose();
  }
  const auto count = static_cast<double>(neighbors.size() + 1);
  const Eigen::Matrix3d covariance = scatter - sum * sum.transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const bool spans_plane = solver.eigenvalues()[1] > 1e-6 * solver.eigenvalues()[2];
  return spans_plane ? Eigen::Vector3f(solver.eigenvectors().col(0).cast<float>())
                     : Eigen::Vector3f::Zero();
}

}  // namespace

Points estimate_normals(const Points& points, const OutwardVote& outward,
                        const NormalEstimationOptions& options) {
  options.validate();
  if (!points.allFinite())
    throw InputError("point cloud", "finite coordinates", "a NaN or infinite one");
  const NeighborLists lists =
      nearest_neighbors(points, static_cast<std::size_t>(options.neighbors));
  Points normals(points.rows(), 3);
  parallel_for_blocks(lists.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      normals.row(i) = tangent_plane_normal(points, i, lists.of(i)).transpose();
    }
  });

  std::vector<bool> visited(lists.size(), false);
  for (Index seed = 0; seed < lists.size(); ++seed) {
    if (visited[seed]) continue;
    const PointIndices piece = spread_signs({seed}, lists, normals, visited);
    double votes = 0.0;
    for (const Index i : piece)
      votes += outward(points.row(i).transpose(), normals.row(i).transpose());
    if (votes >= 0.0) continue;
    for (const Index i : piece) normals.row(i) *= -1.0F;
  }
  return normals;
}

}  // namespace symscene
