#include "boundary_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "core/parallel.hpp"
#include "symmetry/point_residuals.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

constexpr int contractions = 3;

bool has_other_facet(std::span<const Index> neighbors, std::span<const Index> facets, Index i) {
  return std::any_of(neighbors.begin(), neighbors.end(),
                     [&](Index j) { return facets[j] != facets[i]; });
}

/// Neighbours on the other face of a thin wall do not belong to the surface around a point.
constexpr float min_side_cosine = -0.5F;

/// How far the surface bends around a point: the angle between two sides of equal size whose
/// normals have the same mean. [rad]
float bend(const PointCloud& cloud, const CellList& cells, Index i, float radius) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float count = 0.0F;
  cells.for_each_within(cloud.position(i), radius, [&](Index j, float) {
    if (cloud.normal(i).dot(cloud.normal(j)) < min_side_cosine) return;
    sum += cloud.normal(j);
    count += 1.0F;
  });
  return 2.0F * safe_acos(sum.norm() / count);
}

/// The largest angle about a point without neighbours in its tangent plane. [rad]
float largest_gap(const PointCloud& cloud, const CellList& cells, Index i, float radius) {
  const Eigen::Matrix<float, 3, 2> tangents =
      orthonormal_complement(cloud.normal(i).cast<double>()).cast<float>();
  std::vector<float> directions;
  cells.for_each_within(cloud.position(i), radius, [&](Index j, float) {
    if (j == i || cloud.normal(i).dot(cloud.normal(j)) < min_side_cosine) return;
    const Eigen::Vector2f across = tangents.transpose() * (cloud.position(j) - cloud.position(i));
    directions.push_back(std::atan2(across.y(), across.x()));
  });
  constexpr float full_turn = 2.0F * std::numbers::pi_v<float>;
  if (directions.empty()) return full_turn;
  std::sort(directions.begin(), directions.end());
  float largest = directions.front() + full_turn - directions.back();
  for (std::size_t k = 1; k < directions.size(); ++k)
    largest = std::max(largest, directions[k] - directions[k - 1]);
  return largest;
}

/// Where the middle of the band of boundary points around one of them lies. Along the band it stays
/// at the point: means of uneven points would gather in clusters.
Eigen::Vector3f middle_of_band(const Points& boundary, const CellList& cells, Index i,
                               float radius) {
  const Eigen::Vector3f here = boundary.row(i).transpose();
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
  float count = 0.0F;
  cells.for_each_within(here, radius, [&](Index j, float) {
    const Eigen::Vector3f offset = boundary.row(j).transpose() - here;
    sum += offset;
    squares += offset * offset.transpose();
    count += 1.0F;
  });
  const Eigen::Vector3f mean = sum / count;
  const Eigen::Matrix3f scatter = squares / count - mean * mean.transpose();
  const Eigen::Vector3f along =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(scatter).eigenvectors().col(2);
  return here + mean - mean.dot(along) * along;
}

Points contracted(const Points& boundary, float radius) {
  const CellList cells(boundary, radius);
  Points result(boundary.rows(), 3);
  parallel_for_blocks(static_cast<std::size_t>(boundary.rows()), 512,
                      [&](std::size_t begin, std::size_t end) {
                        for (auto i = static_cast<Index>(begin); i < end; ++i)
                          result.row(i) = middle_of_band(boundary, cells, i, radius).transpose();
                      });
  return result;
}

}  // namespace

PointIndices boundary_points(const PointCloud& cloud, const NeighborLists& neighbors,
                             std::span<const Index> facets, const EdgeCurveOptions& options) {
  if (cloud.empty()) return {};
  const auto radius = static_cast<float>(options.radius);
  const auto min_bend = static_cast<float>(options.min_bend);
  const auto min_gap = static_cast<float>(options.min_rim_gap);
  const CellList cells(cloud.positions, radius);
  std::vector<std::uint8_t> is_boundary(cloud.size(), 0);
  parallel_for_blocks(cloud.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      const bool is_edge =
          has_other_facet(neighbors.of(i), facets, i) && bend(cloud, cells, i, radius) >= min_bend;
      const bool is_boundary_point =
          is_edge || (options.outlines && largest_gap(cloud, cells, i, radius) > min_gap);
      is_boundary[i] = is_boundary_point ? 1 : 0;
    }
  });
  PointIndices boundary;
  for (Index i = 0; i < cloud.size(); ++i) {
    if (is_boundary[i] != 0) boundary.push_back(i);
  }
  return boundary;
}

BoundaryNodes boundary_nodes(const PointCloud& cloud, const PointIndices& boundary,
                             const EdgeCurveOptions& options) {
  if (boundary.empty()) return {};
  Points line = select(cloud, boundary).positions;
  for (int round = 0; round < contractions; ++round)
    line = contracted(line, static_cast<float>(options.radius));
  const auto spacing = static_cast<float>(options.spacing);
  const CellList cells(line, static_cast<float>(options.radius));
  std::vector<bool> covered(boundary.size(), false);
  BoundaryNodes nodes;
  for (Index i = 0; i < boundary.size(); ++i) {
    if (covered[i]) continue;
    const Eigen::Vector3f here = line.row(i).transpose();
    EdgeCurve::Point node{here.cast<double>(), Eigen::Vector3d::Zero(), {}};
    cells.for_each_within(here, spacing, [&](Index j, float) {
      if (!covered[j]) node.members.push_back(boundary[j]);
      covered[j] = true;
    });
    std::sort(node.members.begin(), node.members.end());
    nodes.push_back(std::move(node));
  }
  return nodes;
}

}  // namespace symscene
