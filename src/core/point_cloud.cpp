#include "symscene/core/point_cloud.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

namespace symscene {

Box bounding_box(const Points& points) {
  Box box;
  if (points.rows() != 0) {
    box.min = points.colwise().minCoeff().transpose();
    box.max = points.colwise().maxCoeff().transpose();
  }
  return box;
}

PointCloud select(const PointCloud& cloud, std::span<const Index> indices) {
  const auto count = static_cast<Eigen::Index>(indices.size());
  PointCloud selected;
  selected.positions.resize(count, 3);
  selected.normals.resize(cloud.has_normals() ? count : 0, 3);
  selected.colors.resize(cloud.has_colors() ? count : 0, 3);
  for (Eigen::Index row = 0; row < count; ++row) {
    const Index i = indices[static_cast<std::size_t>(row)];
    selected.positions.row(row) = cloud.positions.row(i);
    if (cloud.has_normals()) selected.normals.row(row) = cloud.normals.row(i);
    if (cloud.has_colors()) selected.colors.row(row) = cloud.colors.row(i);
  }
  return selected;
}

Eigen::Vector3d centroid(const Points& points, std::span<const Index> indices) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Index i : indices) sum += points.row(i).transpose().cast<double>();
  return indices.empty() ? sum : Eigen::Vector3d(sum / static_cast<double>(indices.size()));
}

Eigen::Vector3d centroid(const Points& points) {
  if (points.rows() == 0) return Eigen::Vector3d::Zero();
  return points.cast<double>().colwise().mean().transpose();
}

Eigen::Matrix3d principal_axes(const Points& points) {
  const Eigen::Matrix<double, Eigen::Dynamic, 3> centred =
      points.cast<double>().rowwise() - centroid(points).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centred.transpose() * centred);
  return solver.eigenvectors().rowwise().reverse();
}

PointIndices finite_points(const Points& points) {
  PointIndices finite;
  finite.reserve(static_cast<std::size_t>(points.rows()));
  for (Index i = 0; i < points.rows(); ++i) {
    if (points.row(i).allFinite()) finite.push_back(i);
  }
  return finite;
}

PointIndices oriented_points(const PointCloud& cloud) {
  PointIndices oriented;
  for (Index i = 0; i < cloud.normals.rows(); ++i) {
    if (cloud.normals.row(i).squaredNorm() > 0.5F) oriented.push_back(i);
  }
  return oriented;
}

PointIndices evenly_spread(Index size, Index count) {
  PointIndices chosen;
  const Index n = std::min(size, count);
  for (Index k = 0; k < n; ++k) {
    chosen.push_back(static_cast<Index>(std::uint64_t{k} * size / n));
  }
  return chosen;
}

std::size_t intersection_size(std::span<const Index> a, std::span<const Index> b) {
  std::size_t common = 0;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    common += *i == *j;
    const bool advance_i = *i <= *j;
    const bool advance_j = *j <= *i;
    if (advance_i) ++i;
    if (advance_j) ++j;
  }
  return common;
}

double intersection_over_union(std::span<const Index> a, std::span<const Index> b) {
  const std::size_t common = intersection_size(a, b);
  const std::size_t united = a.size() + b.size() - common;
  return united == 0 ? 0.0 : static_cast<double>(common) / static_cast<double>(united);
}

}  // namespace symscene
