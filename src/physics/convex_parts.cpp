#include "symscene/physics/convex_parts.hpp"

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/parallel.hpp"
#include "core/vertex_normals.hpp"
#include "part_clustering.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

/// A mesh with fewer vertices.
struct ThinnedMesh {
  TriangleMesh mesh;
  std::vector<Index> group_of;  ///< per vertex of the full mesh its vertex of the thinned one
};

/// Groups the vertices that lie in one cell and face the same way, so that the two sides of a wall
/// stay apart. The number of the group per vertex.
std::vector<Index> grouped(const TriangleMesh& mesh, float cell) {
  const Points normals = vertex_normals(mesh);
  std::map<std::array<int, 4>, Index> groups;
  std::vector<Index> group_of;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const Eigen::Vector3i at =
        (mesh.vertices.row(i) / cell).array().floor().cast<int>().transpose();
    Eigen::Index axis = 0;
    normals.row(i).cwiseAbs().maxCoeff(&axis);
    const int side = static_cast<int>(2 * axis) + (normals(i, axis) < 0 ? 1 : 0);
    const auto group =
        groups.try_emplace({at.x(), at.y(), at.z(), side}, static_cast<Index>(groups.size()));
    group_of.push_back(group.first->second);
  }
  return group_of;
}

ThinnedMesh thinned(const TriangleMesh& mesh, float cell) {
  ThinnedMesh thin{{}, grouped(mesh, cell)};
  const auto groups =
      static_cast<Eigen::Index>(*std::max_element(thin.group_of.begin(), thin.group_of.end()) + 1);
  thin.mesh.vertices = Points::Zero(groups, 3);
  Eigen::VectorXf members = Eigen::VectorXf::Zero(groups);
  for (std::size_t i = 0; i < thin.group_of.size(); ++i) {
    thin.mesh.vertices.row(thin.group_of[i]) += mesh.vertices.row(static_cast<Eigen::Index>(i));
    members[thin.group_of[i]] += 1.0F;
  }
  thin.mesh.vertices.array().colwise() /= members.array();
  std::set<std::array<Index, 3>> kept;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    std::array<Index, 3> corners{};
    for (int k = 0; k < 3; ++k)
      corners[static_cast<std::size_t>(k)] = thin.group_of[mesh.triangles(t, k)];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[0] != corners[2])
      kept.insert(corners);
  }
  thin.mesh.triangles.resize(static_cast<Eigen::Index>(kept.size()), 3);
  Eigen::Index row = 0;
  for (const auto& [a, b, c] : kept) thin.mesh.triangles.row(row++) << a, b, c;
  return thin;
}

/// The vertices of each part and, so that no part is flat, the same vertices moved inwards by
/// `skin`.
ConvexParts gathered(const TriangleMesh& mesh, const std::vector<Index>& group_of,
                     const std::vector<PointIndices>& parts, float skin) {
  const Points inner = mesh.vertices - skin * vertex_normals(mesh);
  std::vector<PointIndices> vertices_of(*std::max_element(group_of.begin(), group_of.end()) + 1);
  for (Index v = 0; v < group_of.size(); ++v) vertices_of[group_of[v]].push_back(v);
  ConvexParts gathered;
  for (const PointIndices& part : parts) {
    std::size_t size = 0;
    for (const Index group : part) size += vertices_of[group].size();
    Points points(2 * static_cast<Eigen::Index>(size), 3);
    Eigen::Index row = 0;
    for (const Index group : part) {
      for (const Index v : vertices_of[group]) {
        points.row(row++) = mesh.vertices.row(v);
        points.row(row++) = inner.row(v);
      }
    }
    gathered.push_back(std::move(points));
  }
  return gathered;
}

}  // namespace

bool is_solid(const TriangleMesh& mesh) {
  constexpr float thinnest = 1e-3F;
  if (mesh.triangles.rows() < 4 || !mesh.vertices.allFinite()) return false;
  const Points along_axes = mesh.vertices * principal_axes(mesh.vertices).cast<float>();
  return bounding_box(along_axes).extent().minCoeff() > thinnest;
}

ConvexParts convex_parts(const TriangleMesh& mesh, const ConvexPartsOptions& options) {
  options.validate();
  if (!is_solid(mesh)) throw InputError("a mesh", "a solid at least 1 mm thick", "another");
  const double diagonal = bounding_box(mesh.vertices).extent().norm();
  const auto cell = static_cast<float>(std::max(options.cell, diagonal / options.max_cells));
  const ThinnedMesh thin = thinned(mesh, cell);
  const std::vector<PointIndices> parts =
      cluster_convex(thin.mesh, options.concavity, static_cast<std::size_t>(options.max_parts));
  if (parts.size() <= 1) return {mesh.vertices};
  return gathered(mesh, thin.group_of, parts, static_cast<float>(options.skin));
}

}  // namespace symscene
