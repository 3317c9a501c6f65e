#include "symscene/segmentation/oversegmentation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/parallel.hpp"
#include "core/without_repeats.hpp"
#include "region_growing.hpp"

namespace symscene {
namespace {

constexpr Index unassigned = ~Index{0};

PointIndices by_rising(const std::vector<float>& keys) {
  PointIndices order(keys.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return std::pair(keys[a], a) < std::pair(keys[b], b); });
  return order;
}

/// Grows one region at a time over the points that are not yet assigned.
class RegionGrower {
 public:
  RegionGrower(const PointCloud& cloud, const NeighborLists& neighbors, double max_angle,
               double min_smooth_fraction)
      : cloud_(cloud),
        neighbors_(neighbors),
        min_cosine_(static_cast<float>(std::cos(max_angle))),
        min_smooth_fraction_(min_smooth_fraction),
        region_of_(cloud.size(), unassigned) {}

  bool is_free(Index i) const { return region_of_[i] == unassigned; }

  PointIndices grow(Index seed, Index region) {
    PointIndices members{seed};
    region_of_[seed] = region;
    for (std::size_t next = 0; next < members.size(); ++next)
      extend(members[next], region, members);
    std::sort(members.begin(), members.end());
    return members;
  }

 private:
  void extend(Index from, Index region, PointIndices& members) {
    std::size_t free = 0;
    smooth_.clear();
    for (const Index j : neighbors_.of(from)) {
      if (!is_free(j)) continue;
      ++free;
      if (cloud_.normals.row(from).dot(cloud_.normals.row(j)) > min_cosine_) smooth_.push_back(j);
    }
    if (static_cast<double>(smooth_.size()) < min_smooth_fraction_ * static_cast<double>(free))
      return;
    for (const Index j : smooth_) {
      region_of_[j] = region;
      members.push_back(j);
    }
  }

  const PointCloud& cloud_;
  const NeighborLists& neighbors_;
  float min_cosine_;
  double min_smooth_fraction_;
  std::vector<Index> region_of_;
  PointIndices smooth_;
};

/// The segments, sorted largest first, that overlap no larger one by more than `max_overlap` [IoU].
std::vector<PointIndices> without_duplicates(std::vector<PointIndices> segments,
                                             double max_overlap) {
  return without_repeats(std::move(segments), [&](const PointIndices& a, const PointIndices& b) {
    return intersection_over_union(a, b) > max_overlap;
  });
}

}  // namespace

std::vector<float> curvatures(const PointCloud& cloud, const NeighborLists& neighbors) {
  std::vector<float> curvature(cloud.size(), 1.0F);
  parallel_for_blocks(curvature.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      const auto list = neighbors.of(i);
      float cosines = 0.0F;
      for (const Index j : list) cosines += cloud.normals.row(i).dot(cloud.normals.row(j));
      if (!list.empty()) curvature[i] = 1.0F - cosines / static_cast<float>(list.size());
    }
  });
  return curvature;
}

std::vector<PointIndices> grow_regions(const PointCloud& cloud, const NeighborLists& neighbors,
                                       double max_angle, const OversegmentationOptions& options) {
  RegionGrower grower(cloud, neighbors, max_angle, options.min_smooth_fraction);
  std::vector<PointIndices> regions;
  Index region = 0;
  for (const Index seed : by_rising(curvatures(cloud, neighbors))) {
    if (!grower.is_free(seed)) continue;
    PointIndices members = grower.grow(seed, region++);
    if (members.size() >= static_cast<std::size_t>(options.min_size))
      regions.push_back(std::move(members));
  }
  return regions;
}

std::vector<PointIndices> oversegment(const PointCloud& cloud, const NeighborLists& neighbors,
                                      const OversegmentationOptions& options) {
  options.validate();
  const std::array<double, 2> angles{options.fine_angle, options.coarse_angle};
  std::array<std::vector<PointIndices>, 2> runs;
  parallel_for_each(angles.size(), [&](std::size_t run) {
    runs[run] = grow_regions(cloud, neighbors, angles[run], options);
  });
  std::vector<PointIndices> segments;
  for (std::vector<PointIndices>& run : runs) {
    std::move(run.begin(), run.end(), std::back_inserter(segments));
  }
  std::stable_sort(
      segments.begin(), segments.end(),
      [](const PointIndices& a, const PointIndices& b) { return a.size() > b.size(); });
  return without_duplicates(std::move(segments), options.duplicate_overlap);
}

}  // namespace symscene
