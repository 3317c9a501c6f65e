#include "surface_patches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <span>
#include <tuple>

#include "core/as_rows.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr Index no_patch = ~Index{0};

/// The neighbours of each point along the edges of the surface graph.
class Adjacency {
 public:
  Adjacency(std::size_t points, const std::vector<WeightedEdge>& edges)
      : first_(points + 1, 0), neighbors_(2 * edges.size()) {
    for (const WeightedEdge& edge : edges) {
      ++first_[edge.a + 1];
      ++first_[edge.b + 1];
    }
    for (std::size_t i = 0; i < points; ++i) first_[i + 1] += first_[i];
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    for (const WeightedEdge& edge : edges) {
      neighbors_[next[edge.a]++] = edge.b;
      neighbors_[next[edge.b]++] = edge.a;
    }
  }

  std::span<const Index> of(Index i) const {
    return {neighbors_.data() + first_[i], neighbors_.data() + first_[i + 1]};
  }

 private:
  std::vector<Index> first_;
  std::vector<Index> neighbors_;
};

/// One seed per occupied cell of a grid: the point nearest to the middle of those in the cell.
PointIndices grid_seeds(const PointCloud& cloud, float size) {
  std::map<std::tuple<int, int, int>, PointIndices> cells;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3i cell = (cloud.position(i) / size).array().floor().cast<int>();
    cells[{cell.x(), cell.y(), cell.z()}].push_back(i);
  }
  PointIndices seeds;
  for (const auto& [cell, points] : cells) {
    const Eigen::Vector3f middle = centroid(cloud.positions, points).cast<float>();
    seeds.push_back(*std::min_element(points.begin(), points.end(), [&](Index a, Index b) {
      return (cloud.position(a) - middle).squaredNorm() <
             (cloud.position(b) - middle).squaredNorm();
    }));
  }
  return seeds;
}

struct Seed {
  Index point;
  Eigen::Vector3f normal;
};

/// The patch of every point, by the shortest path from a seed (Dijkstra 1959).
std::vector<Index> nearest_seeds(const PointCloud& cloud, const Adjacency& adjacency,
                                 const std::vector<Seed>& seeds,
                                 const SurfacePartsOptions& options) {
  const auto size = static_cast<float>(options.patch_size);
  const auto bend_cost = static_cast<float>(options.bend_cost);
  struct Step {
    float cost;
    Index point, patch;
    bool operator<(const Step& other) const {  // the cheapest is on top
      return std::tie(cost, point, patch) > std::tie(other.cost, other.point, other.patch);
    }
  };
  std::vector<Index> patch_of(cloud.size(), no_patch);
  std::vector<float> best(cloud.size(), std::numeric_limits<float>::max());
  std::priority_queue<Step> queue;
  for (Index s = 0; s < seeds.size(); ++s) {
    best[seeds[s].point] = 0.0F;
    queue.push({0.0F, seeds[s].point, s});
  }
  while (!queue.empty()) {
    const Step step = queue.top();
    queue.pop();
    if (patch_of[step.point] != no_patch) continue;
    patch_of[step.point] = step.patch;
    for (const Index next : adjacency.of(step.point)) {
      if (patch_of[next] != no_patch) continue;
      const float length = (cloud.position(next) - cloud.position(step.point)).norm() / size;
      const float bend = 1.0F - seeds[step.patch].normal.dot(cloud.normal(next));
      const float cost = step.cost + length * (1.0F + bend_cost * bend);
      if (cost >= best[next]) continue;
      best[next] = cost;
      queue.push({cost, next, step.patch});
    }
  }
  return patch_of;
}

std::vector<SurfacePatch> patches_of(const PointCloud& cloud, const std::vector<Index>& patch_of,
                                     std::size_t seeds) {
  std::vector<SurfacePatch> patches(seeds);
  for (Index i = 0; i < cloud.size(); ++i) {
    SurfacePatch& patch = patch_of[i] == no_patch ? patches.emplace_back() : patches[patch_of[i]];
    patch.points.push_back(i);
    patch.normal += cloud.normal(i);
  }
  std::erase_if(patches, [](const SurfacePatch& patch) { return patch.points.empty(); });
  for (SurfacePatch& patch : patches) {
    patch.center = centroid(cloud.positions, patch.points).cast<float>();
    patch.normal.normalize();
  }
  return patches;
}

/// The point of a patch that is nearest to its centre.
Seed middle_seed(const PointCloud& cloud, const SurfacePatch& patch) {
  const Index middle =
      *std::min_element(patch.points.begin(), patch.points.end(), [&](Index a, Index b) {
        return (cloud.position(a) - patch.center).squaredNorm() <
               (cloud.position(b) - patch.center).squaredNorm();
      });
  return {middle, patch.normal};
}

float angle_above(const Eigen::Vector3f& normal, const Eigen::Vector3f& direction) {
  return std::asin(std::clamp(normal.dot(direction), -1.0F, 1.0F));
}

}  // namespace

std::vector<SurfacePatch> surface_patches(const PointCloud& cloud,
                                          const std::vector<WeightedEdge>& edges,
                                          const SurfacePartsOptions& options) {
  const auto size = static_cast<float>(options.patch_size);
  const Adjacency adjacency(cloud.size(), edges);
  std::vector<Seed> seeds;
  for (const Index point : grid_seeds(cloud, size)) seeds.push_back({point, cloud.normal(point)});
  std::vector<SurfacePatch> patches;
  for (int round = 0; round < options.patch_rounds; ++round) {
    patches = patches_of(cloud, nearest_seeds(cloud, adjacency, seeds, options), seeds.size());
    seeds.clear();
    for (const SurfacePatch& patch : patches) seeds.push_back(middle_seed(cloud, patch));
  }
  return patches;
}

std::vector<std::pair<Index, Index>> patches_across_gaps(const std::vector<SurfacePatch>& patches,
                                                         const SurfacePartsOptions& options) {
  const auto reach = static_cast<float>(options.max_patch_gap * options.patch_size);
  const Points centers = as_rows(patches, [](const SurfacePatch& patch) { return patch.center; });
  std::vector<std::pair<Index, Index>> pairs;
  if (patches.empty()) return pairs;
  const CellList cells(centers, reach);
  for (Index a = 0; a < patches.size(); ++a) {
    cells.for_each_within(patches[a].center, reach, [&](Index b, float) {
      if (a < b) pairs.emplace_back(a, b);
    });
  }
  return pairs;
}

float patch_concavity(const SurfacePatch& a, const SurfacePatch& b) {
  const Eigen::Vector3f along = (b.center - a.center).normalized();
  const float above_a = angle_above(a.normal, along), above_b = angle_above(b.normal, -along);
  const float fold = std::max(0.0F, above_a + above_b);
  const float step =
      above_a * above_b < 0.0F ? std::min(std::abs(above_a), std::abs(above_b)) : 0.0F;
  return fold + step;
}

}  // namespace symscene
