#include "segmentation/surface_regions.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <queue>
#include <tuple>

#include "core/disjoint_sets.hpp"
#include "region_growing.hpp"
#include "surface_patches.hpp"

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

/// The region of every point.
std::vector<Index> labels_of(std::size_t points, const std::vector<PointIndices>& regions) {
  std::vector<Index> labels(points);
  for (Index r = 0; r < regions.size(); ++r) {
    for (const Index i : regions[r]) labels[i] = r;
  }
  return labels;
}

}  // namespace

SurfaceRegions::SurfaceRegions(std::size_t points, std::vector<PointIndices> regions,
                               const Borders& borders, const SurfacePartsOptions& options)
    : options_(options), regions_(std::move(regions)), region_of_(labels_of(points, regions_)) {
  options_.validate();
  meetings_of_.resize(regions_.size());
  for (const auto& [pair, border] : borders) {
    const auto meeting = static_cast<Index>(meetings_.size());
    meetings_of_[pair.first].push_back(meeting);
    meetings_of_[pair.second].push_back(meeting);
    meetings_.push_back({pair.first, pair.second, border});
  }
}

std::vector<PointIndices> SurfaceRegions::parts() const {
  std::vector<PointIndices> parts = tree().points;
  erase_small(parts);
  return parts;
}

std::vector<PointIndices> SurfaceRegions::parts_at(std::span<const double> weaknesses) const {
  Tree all = tree();
  std::vector<PointIndices> parts;
  for (std::size_t node = 0; node < all.points.size(); ++node) {
    const bool exists = std::any_of(weaknesses.begin(), weaknesses.end(), [&](double weakness) {
      return all.joined_at[node] <= weakness && weakness < all.consumed_at[node];
    });
    if (exists) parts.push_back(std::move(all.points[node]));
  }
  erase_small(parts);
  return parts;
}

void SurfaceRegions::erase_small(std::vector<PointIndices>& parts) const {
  std::erase_if(parts, [&](const PointIndices& part) {
    return part.size() < static_cast<std::size_t>(options_.min_size);
  });
}

SurfaceRegions::Tree SurfaceRegions::tree() const {
  std::vector<std::size_t> sizes;
  for (const PointIndices& region : regions_) sizes.push_back(region.size());
  RegionJoiner joiner(std::move(sizes), static_cast<std::size_t>(options_.fragment));
  for (const Meeting& meeting : meetings_) joiner.add_border(meeting.a, meeting.b, meeting.border);
  constexpr double never = std::numeric_limits<double>::infinity();
  Tree tree{regions_, std::vector<double>(regions_.size(), 0.0),
            std::vector<double>(regions_.size(), never)};
  joiner.run([&](Index a, Index b, double bend) {
    PointIndices points;
    points.reserve(tree.points[a].size() + tree.points[b].size());
    std::merge(tree.points[a].begin(), tree.points[a].end(), tree.points[b].begin(),
               tree.points[b].end(), std::back_inserter(points));
    tree.points.push_back(std::move(points));
    // A border may be stronger than those that were merged before it.
    const double at = std::max({bend, tree.joined_at[a], tree.joined_at[b]});
    tree.consumed_at[a] = tree.consumed_at[b] = at;
    tree.joined_at.push_back(at);
    tree.consumed_at.push_back(never);
  });
  return tree;
}

/// The regions that belong to a proposal, and how many of its points each holds.
std::map<Index, std::size_t> SurfaceRegions::held_by(std::span<const Index> points) const {
  std::map<Index, std::size_t> held;
  for (const Index i : points) ++held[region_of_[i]];
  std::erase_if(held, [&](const auto& entry) {
    return static_cast<double>(entry.second) <
           options_.min_region_share * static_cast<double>(regions_[entry.first].size());
  });
  return held;
}

double SurfaceRegions::unity(std::span<const Index> points) const {
  const std::map<Index, std::size_t> held = held_by(points);
  DisjointSets sets(regions_.size());
  std::size_t all = 0, largest = 0;
  for (const auto& [region, count] : held) {
    all += count;
    for (const Index m : meetings_of_[region]) {
      const Meeting& meeting = meetings_[m];
      if (held.contains(meeting.a) && held.contains(meeting.b)) sets.join(meeting.a, meeting.b);
    }
  }
  std::map<Index, std::size_t> sizes;
  for (const auto& [region, count] : held)
    largest = std::max(largest, sizes[sets.leader(region)] += count);
  return all > 0 ? static_cast<double>(largest) / static_cast<double>(all) : 1.0;
}

double SurfaceRegions::rim(std::span<const Index> points) const {
  const std::map<Index, std::size_t> held = held_by(points);
  RegionBorder rim;
  for (const auto& [region, count] : held) {
    for (const Index m : meetings_of_[region]) {
      const Meeting& meeting = meetings_[m];
      if (!held.contains(meeting.a == region ? meeting.b : meeting.a)) rim += meeting.border;
    }
  }
  return rim.edges > 0.0 ? rim.bend() : 1.0;
}

double SurfaceRegions::seam(std::span<const Index> points) const {
  const std::map<Index, std::size_t> held = held_by(points);
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

SurfaceRegions smooth_regions(const PointCloud& cloud, const std::vector<WeightedEdge>& edges,
                              const NeighborLists& neighbors, const SurfacePartsOptions& options) {
  options.validate();
  OversegmentationOptions growing;
  growing.min_size = 1;
  growing.min_smooth_fraction = options.min_smooth_fraction;
  std::vector<PointIndices> regions = grow_regions(cloud, neighbors, options.smooth_angle, growing);
  const std::vector<Index> region_of = labels_of(cloud.size(), regions);
  SurfaceRegions::Borders borders;
  for (const WeightedEdge& edge : edges) {
    const Index a = region_of[edge.a], b = region_of[edge.b];
    if (a != b) borders[std::minmax(a, b)] += {1.0, 1.0 - double{edge.weight}};
  }
  return {cloud.size(), std::move(regions), borders, options};
}

SurfaceRegions patch_regions(const PointCloud& cloud, const std::vector<WeightedEdge>& edges,
                             const SurfacePartsOptions& options) {
  options.validate();
  const std::vector<SurfacePatch> patches = surface_patches(cloud, edges, options);
  std::vector<PointIndices> regions;
  for (const SurfacePatch& patch : patches) regions.push_back(patch.points);
  const std::vector<Index> region_of = labels_of(cloud.size(), regions);
  SurfaceRegions::Borders borders;
  for (const WeightedEdge& edge : edges) {
    const Index a = region_of[edge.a], b = region_of[edge.b];
    if (a != b) borders[std::minmax(a, b)].edges += 1.0;
  }
  for (const auto& pair : patches_across_gaps(patches, options)) {
    RegionBorder& border = borders[pair];
    if (border.edges == 0.0) border.edges = options.gap_edges;
  }
  for (auto& [pair, border] : borders) {
    const double fold = double{patch_concavity(patches[pair.first], patches[pair.second])};
    border.weakness = border.edges * std::min(1.0, fold / (0.5 * std::numbers::pi));
  }
  return {cloud.size(), std::move(regions), borders, options};
}

}  // namespace symscene
