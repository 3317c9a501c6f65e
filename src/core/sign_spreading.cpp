#include "core/sign_spreading.hpp"

#include <cmath>
#include <queue>
#include <utility>

namespace symscene {
namespace {

/// An edge of the spanning tree; edges of low cost are taken first.
struct Spread {
  float cost;
  Index from;
  Index to;
  bool operator<(const Spread& other) const {
    if (cost != other.cost) return cost > other.cost;
    return std::pair(from, to) > std::pair(other.from, other.to);
  }
};

}  // namespace

PointIndices spread_signs(const PointIndices& seeds, const NeighborLists& lists, Points& normals,
                          std::vector<bool>& visited) {
  PointIndices piece;
  std::priority_queue<Spread> queue;
  const auto visit = [&](Index i) {
    visited[i] = true;
    piece.push_back(i);
    for (const Index j : lists.of(i)) {
      if (!visited[j]) queue.push({1.0F - std::abs(normals.row(i).dot(normals.row(j))), i, j});
    }
  };
  for (const Index seed : seeds) visit(seed);
  while (!queue.empty()) {
    const Spread edge = queue.top();
    queue.pop();
    if (visited[edge.to]) continue;
    if (normals.row(edge.from).dot(normals.row(edge.to)) < 0.0F) normals.row(edge.to) *= -1.0F;
    visit(edge.to);
  }
  return piece;
}

}  // namespace symscene
