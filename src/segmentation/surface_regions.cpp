#include "segmentation/surface_regions.hpp"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

#include "region_growing.hpp"

namespace symscene {
namespace {

/// Merges nodes two at a time; a merged node gets the next number. Fragments, such as the rounding
/// of an edge, are not surfaces of their own and are merged first.
class RegionJoiner {
 public:
  RegionJoiner(std::vector<std::size_t> sizes, std::size_t fragment)
      : fragment_(fragment),
        sizes_(std::move(sizes)),
        borders_(sizes_.size()),
        alive_(sizes_.size(), true) {}

  void add_border(Index a, Index b, const RegionBorder& border) {
    borders_[a][b] += border;
    borders_[b][a] += border;
  }

  /// Calls on_join(a, b, bend of the border between them) before each merge.
  template <class OnJoin>
  void run(OnJoin&& on_join) {
    for (Index a = 0; a < borders_.size(); ++a) {
      for (const auto& [b, border] : borders_[a]) {
        if (a < b) push(a, b, border);
      }
    }
    while (!queue_.empty()) {
      const Candidate next = queue_.top();
      queue_.pop();
      if (!alive_[next.a] || !alive_[next.b]) continue;
      const double bend = borders_[next.a].at(next.b).bend();
      on_join(next.a, next.b, bend);
      join(next.a, next.b);
    }
  }

  std::size_t size(Index node) const { return sizes_[node]; }

 private:
  struct Candidate {
    double cost;
    Index a, b;
    bool operator<(const Candidate& other) const {  // the cheapest is on top
      return std::tuple(cost, a, b) > std::tuple(other.cost, other.a, other.b);
    }
  };

  void push(Index a, Index b, const RegionBorder& border) {
    const bool fragment = std::min(sizes_[a], sizes_[b]) < fragment_;
    queue_.push({border.bend() - (fragment ? 1.0 : 0.0), a, b});
  }

  void join(Index a, Index b) {
    const auto joined = static_cast<Index>(sizes_.size());
    sizes_.push_back(sizes_[a] + sizes_[b]);
    alive_[a] = alive_[b] = false;
    alive_.push_back(true);
    // The shorter list goes into the longer: fragments join surfaces with many borders.
    if (borders_[a].size() < borders_[b].size()) std::swap(borders_[a], borders_[b]);
    std::map<Index, RegionBorder> around = std::move(borders_[a]);
    for (const auto& [other, border] : borders_[b]) around[other] += border;
    around.erase(a);
    around.erase(b);
    for (const auto& [other, border] : around) {
      borders_[other].erase(a);
      borders_[other].erase(b);
      borders_[other][joined] = border;
      push(other, joined, border);
    }
    borders_[a].clear();
    borders_[b].clear();
    borders_.push_back(std::move(around));
  }

  std::size_t fragment_;
  std::vector<std::size_t> sizes_;
  std::vector<std::map<Index, RegionBorder>> borders_;
  std::vector<bool> alive_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

SurfaceRegions::SurfaceRegions(const PointCloud& cloud, const std::vector<WeightedEdge>& edges,
                               const NeighborLists& neighbors, const SurfacePartsOptions& options)
    : options_(options) {
  options_.validate();
  OversegmentationOptions growing;
  growing.min_size = 1;
  growing.min_smooth_fraction = options_.min_smooth_fraction;
  regions_ = grow_regions(cloud, neighbors, options_.smooth_angle, growing);
  region_of_.resize(cloud.size());
  for (Index r = 0; r < regions_.size(); ++r) {
    for (const Index i : regions_[r]) region_of_[i] = r;
  }
  std::map<std::pair<Index, Index>, RegionBorder> borders;
  for (const WeightedEdge& edge : edges) {
    const Index a = region_of_[edge.a], b = region_of_[edge.b];
    if (a != b) borders[std::minmax(a, b)] += {1.0, 1.0 - double{edge.weight}};
  }
  meetings_of_.resize(regions_.size());
  for (const auto& [pair, border] : borders) {
    const auto meeting = static_cast<Index>(meetings_.size());
    meetings_of_[pair.first].push_back(meeting);
    meetings_of_[pair.second].push_back(meeting);
    meetings_.push_back({pair.first, pair.second, border});
  }
}

std::vector<PointIndices> SurfaceRegions::parts() const {
  std::vector<std::size_t> sizes;
  for (const PointIndices& region : regions_) sizes.push_back(region.size());
  RegionJoiner joiner(std::move(sizes), static_cast<std::size_t>(options_.fragment));
  for (const Meeting& meeting : meetings_) joiner.add_border(meeting.a, meeting.b, meeting.border);
  std::vector<PointIndices> parts = regions_;
  joiner.run([&](Index a, Index b, double) {
    PointIndices points;
    points.reserve(parts[a].size() + parts[b].size());
    std::merge(parts[a].begin(), parts[a].end(), parts[b].begin(), parts[b].end(),
               std::back_inserter(points));
    parts.push_back(std::move(points));
  });
  std::erase_if(parts, [&](const PointIndices& part) {
    return part.size() < static_cast<std::size_t>(options_.min_size);
  });
  return parts;
}

double SurfaceRegions::seam(std::span<const Index> points) const {
  std::map<Index, std::size_t> held;  // points of the set by region
  for (const Index i : points) ++held[region_of_[i]];
  std::erase_if(held, [&](const auto& entry) {
    return static_cast<double>(entry.second) <
           options_.min_region_share * static_cast<double>(regions_[entry.first].size());
  });
  std::vector<std::size_t> sizes;
  std::map<Index, Index> node_of;
  for (const auto& [region, count] : held) {
    node_of[region] = static_cast<Index>(sizes.size());
    sizes.push_back(count);
  }
  RegionJoiner joiner(std::move(sizes), static_cast<std::size_t>(options_.fragment));
  for (const auto& [region, node] : node_of) {
    for (const Index m : meetings_of_[region]) {
      const Meeting& meeting = meetings_[m];
      const auto other = node_of.find(meeting.b);
      if (meeting.a == region && other != node_of.end())
        joiner.add_border(node, other->second, meeting.border);
    }
  }
  const double least = options_.min_seam_share * static_cast<double>(points.size());
  double seam = 0.0;
  joiner.run([&](Index a, Index b, double bend) {
    if (static_cast<double>(std::min(joiner.size(a), joiner.size(b))) >= least)
      seam = std::max(seam, bend);
  });
  return seam;
}

}  // namespace symscene
