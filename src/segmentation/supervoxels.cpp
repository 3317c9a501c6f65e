#include "symscene/segmentation/supervoxels.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>

#include "core/disjoint_sets.hpp"
#include "region_growing.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr Index no_label = ~Index{0};

/// The centre of a supervoxel: means over its points.
struct SupervoxelCentre {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;
};

/// The points that paths of neighbours reach from a seed without leaving a ball around it.
class BallSearch {
 public:
  BallSearch(const PointCloud& cloud, const NeighborLists& neighbors)
      : cloud_(cloud), neighbors_(neighbors), visited_(cloud.size(), no_label) {}

  const PointIndices& reach(Index seed, float radius) {
    reached_.assign(1, seed);
    visited_[seed] = seed;
    for (std::size_t next = 0; next < reached_.size(); ++next) {
      for (const Index j : neighbors_.of(reached_[next])) {
        if (visited_[j] == seed) continue;
        if ((cloud_.positions.row(j) - cloud_.positions.row(seed)).norm() >= radius) continue;
        visited_[j] = seed;
        reached_.push_back(j);
      }
    }
    return reached_;
  }

 private:
  const PointCloud& cloud_;
  const NeighborLists& neighbors_;
  std::vector<Index> visited_;  ///< per point, the last seed that reached it
  PointIndices reached_;
};

/// Points at least `spacing` apart along the surface that leave no point farther from all of them.
PointIndices spread_seeds(const PointCloud& cloud, const NeighborLists& neighbors, float spacing) {
  BallSearch ball(cloud, neighbors);
  std::vector<bool> covered(cloud.size(), false);
  PointIndices seeds;
  for (Index i = 0; i < cloud.size(); ++i) {
    if (covered[i]) continue;
    seeds.push_back(i);
    for (const Index j : ball.reach(i, spacing)) covered[j] = true;
  }
  return seeds;
}

/// Moves each seed to the flattest point around it, so that none starts on an edge.
PointIndices flattest_seeds(const PointCloud& cloud, const NeighborLists& neighbors,
                            const PointIndices& seeds, float spacing) {
  const std::vector<float> curvature = curvatures(cloud, neighbors);
  BallSearch ball(cloud, neighbors);
  std::vector<bool> taken(cloud.size(), false);
  PointIndices moved;
  for (const Index seed : seeds) {
    Index best = seed;
    for (const Index j : ball.reach(seed, spacing / 2.0F)) {
      if (!taken[j] && (curvature[j] < curvature[best] || taken[best])) best = j;
    }
    if (taken[best]) continue;
    taken[best] = true;
    moved.push_back(best);
  }
  return moved;
}

/// Grows supervoxels from their starts over neighbours, the point nearest to its centre first.
class SupervoxelGrower {
 public:
  SupervoxelGrower(const PointCloud& cloud, const NeighborLists& neighbors,
                   const SupervoxelOptions& options)
      : cloud_(cloud),
        neighbors_(neighbors),
        spatial_(static_cast<float>(options.spatial_weight /
                                    (options.seed_spacing * options.seed_spacing))),
        normal_(static_cast<float>(options.normal_weight)) {}

  /// The metric of the paper, squared, without colour.
  float squared_distance(Index i, const SupervoxelCentre& centre) const {
    return spatial_ * (cloud_.position(i) - centre.position).squaredNorm() +
           normal_ * (1.0F - cloud_.normal(i).dot(centre.normal));
  }

  std::vector<Index> grow(const PointIndices& starts,
                          const std::vector<SupervoxelCentre>& centres) const {
    using Step = std::tuple<float, Index, Index>;  // distance, label, point
    using Offer = std::pair<float, Index>;         // distance, label
    std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
    std::vector<Index> labels(cloud_.size(), no_label);
    // Of the steps to a point only the least is taken, so that later ones must be less.
    std::vector<Offer> least(cloud_.size(), {std::numeric_limits<float>::max(), no_label});
    for (Index label = 0; label < starts.size(); ++label)
      steps.emplace(-1.0F, label, starts[label]);
    while (!steps.empty()) {
      const auto [distance, label, point] = steps.top();
      steps.pop();
      if (labels[point] != no_label) continue;
      labels[point] = label;
      for (const Index j : neighbors_.of(point)) {
        if (labels[j] != no_label) continue;
        const Offer offer{squared_distance(j, centres[label]), label};
        if (!(offer < least[j])) continue;
        least[j] = offer;
        steps.emplace(offer.first, label, j);
      }
    }
    return labels;
  }

  std::vector<SupervoxelCentre> centres(const std::vector<Index>& labels, std::size_t count) const {
    std::vector<SupervoxelCentre> sums(count, {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()});
    std::vector<float> sizes(count, 0.0F);
    for (Index i = 0; i < cloud_.size(); ++i) {
      sums[labels[i]].position += cloud_.position(i);
      sums[labels[i]].normal += cloud_.normal(i);
      sizes[labels[i]] += 1.0F;
    }
    for (std::size_t k = 0; k < count; ++k) {
      sums[k].position /= sizes[k];
      sums[k].normal.normalize();
    }
    return sums;
  }

  /// The point of each supervoxel that is nearest to its centre.
  PointIndices starts(const std::vector<Index>& labels,
                      const std::vector<SupervoxelCentre>& centres) const {
    PointIndices nearest(centres.size(), no_label);
    std::vector<float> distances(centres.size());
    for (Index i = 0; i < cloud_.size(); ++i) {
      const Index label = labels[i];
      const float distance = squared_distance(i, centres[label]);
      if (nearest[label] != no_label && distance >= distances[label]) continue;
      nearest[label] = i;
      distances[label] = distance;
    }
    return nearest;
  }

 private:
  const PointCloud& cloud_;
  const NeighborLists& neighbors_;
  float spatial_;
  float normal_;
};

/// The labels renumbered without gaps, in the order of their first point.
Partition compacted(const std::vector<Index>& labels) {
  Partition partition;
  std::vector<Index> place(labels.size(), no_label);
  for (const Index label : labels) {
    if (place[label] == no_label) place[label] = partition.count++;
    partition.labels.push_back(place[label]);
  }
  return partition;
}

}  // namespace

void SupervoxelOptions::validate() const {
  check_fields(*this);
  require_option(spatial_weight > 0.0 || normal_weight > 0.0, "spatial_weight",
                 "a weight above zero, or a normal_weight above zero", spatial_weight);
}

Partition supervoxels(const PointCloud& cloud, const NeighborLists& neighbors,
                      const SupervoxelOptions& options) {
  options.validate();
  const auto spacing = static_cast<float>(options.seed_spacing);
  const SupervoxelGrower grower(cloud, neighbors, options);
  PointIndices starts =
      flattest_seeds(cloud, neighbors, spread_seeds(cloud, neighbors, spacing), spacing);
  std::vector<SupervoxelCentre> centres;
  for (const Index i : starts) centres.push_back({cloud.position(i), cloud.normal(i)});
  std::vector<Index> labels;
  for (int round = 0; round < options.iterations; ++round) {
    labels = grower.grow(starts, centres);
    centres = grower.centres(labels, starts.size());
    starts = grower.starts(labels, centres);
  }
  return compacted(labels);
}

Partition facets(const PointCloud& cloud, const NeighborLists& neighbors,
                 const SupervoxelOptions& options) {
  const Partition fine = supervoxels(cloud, neighbors, options);
  const std::vector<SupervoxelCentre> centres =
      SupervoxelGrower(cloud, neighbors, options).centres(fine.labels, fine.count);
  const auto min_cosine = static_cast<float>(std::cos(options.merge_angle));
  DisjointSets merged(fine.count);
  for (Index i = 0; i < cloud.size(); ++i) {
    for (const Index j : neighbors.of(i)) {
      const Index a = fine.labels[i], b = fine.labels[j];
      if (a < b && centres[a].normal.dot(centres[b].normal) > min_cosine) merged.join(a, b);
    }
  }
  std::vector<Index> labels;
  for (const Index label : fine.labels) labels.push_back(merged.leader(label));
  return compacted(labels);
}

}  // namespace symscene
