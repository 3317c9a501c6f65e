#include "weld.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace symscene {
namespace {

/// For every vertex the first one at its position.
std::vector<Index> first_at_place(const Points& vertices) {
  // Bits have an order where floats have none (NaN). Adding zero turns −0 into 0.
  const auto place = [&](Index v) {
    const auto bits = [&](Eigen::Index k) {
      return std::bit_cast<std::uint32_t>(vertices(v, k) + 0.0F);
    };
    return std::array{bits(0), bits(1), bits(2)};
  };
  std::vector<Index> order(static_cast<std::size_t>(vertices.rows()));
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return place(a) != place(b) ? place(a) < place(b) : a < b; });
  std::vector<Index> first(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool again = k > 0 && place(order[k]) == place(order[k - 1]);
    first[order[k]] = again ? first[order[k - 1]] : order[k];
  }
  return first;
}

}  // namespace

TriangleMesh weld_vertices(const TriangleMesh& mesh) {
  const std::vector<Index> first = first_at_place(mesh.vertices);
  std::vector<Index> kept;
  std::vector<Index> new_index(first.size());
  for (Index v = 0; v < first.size(); ++v) {
    if (first[v] == v) kept.push_back(v);
    new_index[v] = first[v] == v ? static_cast<Index>(kept.size() - 1) : new_index[first[v]];
  }
  TriangleMesh welded;
  welded.vertices = mesh.vertices(kept, Eigen::all);
  if (mesh.colors.rows() != 0) welded.colors = mesh.colors(kept, Eigen::all);
  welded.triangles.resize(mesh.triangles.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Index a = new_index[mesh.triangles(t, 0)];
    const Index b = new_index[mesh.triangles(t, 1)];
    const Index c = new_index[mesh.triangles(t, 2)];
    if (a != b && b != c && c != a) welded.triangles.row(count++) << a, b, c;
  }
  welded.triangles.conservativeResize(count, 3);
  return welded;
}

}  // namespace symscene
