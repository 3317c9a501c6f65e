#include "small_pieces.hpp"

#include <algorithm>
#include <numeric>

namespace symscene {
namespace {

/// The root of a vertex' tree (union-find with path halving).
Index find_root(std::vector<Index>& parents, Index i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

/// The vertices of the mesh joined by its triangles: the root of each vertex.
std::vector<Index> connected_roots(const TriangleMesh& mesh) {
  std::vector<Index> parents(static_cast<std::size_t>(mesh.vertices.rows()));
  std::iota(parents.begin(), parents.end(), Index{0});
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Index root = find_root(parents, mesh.triangles(t, 0));
    parents[find_root(parents, mesh.triangles(t, 1))] = root;
    parents[find_root(parents, mesh.triangles(t, 2))] = root;
  }
  for (Index v = 0; v < parents.size(); ++v) parents[v] = find_root(parents, v);
  return parents;
}

}  // namespace

TriangleMesh without_small_pieces(const TriangleMesh& mesh, int min_triangles) {
  const std::vector<Index> roots = connected_roots(mesh);
  std::vector<int> triangles(roots.size(), 0);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    int& count = triangles[roots[mesh.triangles(t, 0)]];
    count = std::min(count + 1, min_triangles);
  }
  std::vector<Index> kept, place(roots.size(), 0);
  for (Index v = 0; v < roots.size(); ++v) {
    if (triangles[roots[v]] < min_triangles) continue;
    place[v] = static_cast<Index>(kept.size());
    kept.push_back(v);
  }
  TriangleMesh result;
  result.vertices = mesh.vertices(kept, Eigen::all);
  result.normals = mesh.normals(kept, Eigen::all);
  if (mesh.colors.rows() != 0) result.colors = mesh.colors(kept, Eigen::all);
  result.triangles.resize(mesh.triangles.rows(), 3);
  Eigen::Index row = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    if (triangles[roots[mesh.triangles(t, 0)]] < min_triangles) continue;
    for (int c = 0; c < 3; ++c) result.triangles(row, c) = place[mesh.triangles(t, c)];
    ++row;
  }
  result.triangles.conservativeResize(row, 3);
  return result;
}

}  // namespace symscene
