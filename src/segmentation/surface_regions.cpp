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

/// The borders of one node, by the node on the other side, ascending.
using NodeBorders = std::vector<std::pair<Index, RegionBorder>>;

NodeBorders::iterator place_of(NodeBorders& borders, Index other) {
  return std::lower_bound(
      borders.begin(), borders.end(), other,
      [](const NodeBorders::value_type& border, Index node) { return border.first < node; });
}

void add_border_to(NodeBorders& borders, Index other, const RegionBorder& border) {
  const auto place = place_of(borders, other);
  if (place != borders.end() && place->first == other) {
    place->second += border;
  } else {
    borders.emplace(place, other, border);
  }
}

/// The borders of the union of two nodes to nodes that are alive.
NodeBorders joined_borders(const NodeBorders& of_a, const NodeBorders& of_b,
                           const std::vector<bool>& alive) {
  NodeBorders joined;
  joined.reserve(of_a.size() + of_b.size());
  auto next_a = of_a.begin(), next_b = of_b.begin();
  while (next_a != of_a.end() || next_b != of_b.end()) {
    const bool takes_a =
        next_b == of_b.end() || (next_a != of_a.end() && next_a->first <= next_b->first);
    const bool takes_b =
        next_a == of_a.end() || (next_b != of_b.end() && next_b->first <= next_a->first);
    std::pair<Index, RegionBorder> border = takes_a ? *next_a : *next_b;
    if (takes_a && takes_b) border.second += next_b->second;
    if (takes_a) ++next_a;
    if (takes_b) ++next_b;
    if (alive[border.first]) joined.push_back(border);
  }
  return joined;
}

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
    add_border_to(borders_[a], b, border);
    add_border_to(borders_[b], a, border);
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
      on_join(next.a, next.b, next.bend);
      join(next.a, next.b);
    }
  }

  std::size_t size(Index node) const { return sizes_[node]; }

 private:
  struct Candidate {
    double cost;
    Index a, b;
    double bend;  ///< of their border, which stays as it is until one of them is merged
    bool operator<(const Candidate& other) const {  // the cheapest is on top
      return std::tie(cost, a, b) > std::tie(other.cost, other.a, other.b);
    }
  };

  void push(Index a, Index b, const RegionBorder& border) {
    const bool fragment = std::min(sizes_[a], sizes_[b]) < fragment_;
    const double bend = border.bend();
    queue_.push({bend - (fragment ? 1.0 : 0.0), a, b, bend});
  }

  void join(Index a, Index b) {
    const auto joined = static_cast<Index>(sizes_.size());
    sizes_.push_back(sizes_[a] + sizes_[b]);
    alive_[a] = alive_[b] = false;
    alive_.push_back(true);
    NodeBorders around = joined_borders(borders_[a], borders_[b], alive_);
    for (const auto& [other, border] : around) {
      // Its borders to a and b stay in its list, where joined_borders() passes over them.
      borders_[other].emplace_back(joined, border);  // the greatest number so far
      push(other, joined, border);
    }
    borders_[a] = {};
    borders_[b] = {};
    borders_.push_back(std::move(around));
  }

  std::size_t fragment_;
  std::vector<std::size_t> sizes_;
  std::vector<NodeBorders> borders_;
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

SurfaceRegions::Held SurfaceRegions::held_by(std::span<const Index> points) const {
  std::vector<std::size_t> counts(regions_.size(), 0);
  for (const Index i : points) ++counts[region_of_[i]];
  Held held;
  held.place.assign(regions_.size(), Held::none);
  for (Index region = 0; region < regions_.size(); ++region) {
    const auto size = static_cast<double>(regions_[region].size());
    if (counts[region] == 0 ||
        static_cast<double>(counts[region]) < options_.min_region_share * size)
      continue;
    held.place[region] = static_cast<Index>(held.regions.size());
    held.regions.push_back(region);
    held.counts.push_back(counts[region]);
  }
  return held;
}

double SurfaceRegions::unity(std::span<const Index> points) const {
  const Held held = held_by(points);
  DisjointSets sets(held.regions.size());
  for (const Index region : held.regions) {
    for (const Index m : meetings_of_[region]) {
      const Meeting& meeting = meetings_[m];
      if (held.contains(meeting.a) && held.contains(meeting.b))
        sets.join(held.place[meeting.a], held.place[meeting.b]);
    }
  }
  std::vector<std::size_t> sizes(held.regions.size(), 0);
  std::size_t all = 0, largest = 0;
  for (Index node = 0; node < held.regions.size(); ++node) {
    all += held.counts[node];
    largest = std::max(largest, sizes[sets.leader(node)] += held.counts[node]);
  }
  return all > 0 ? static_cast<double>(largest) / static_cast<double>(all) : 1.0;
}

double SurfaceRegions::rim(std::span<const Index> points) const {
  const Held held = held_by(points);
  RegionBorder rim;
  for (const Index region : held.regions) {
    for (const Index m : meetings_of_[region]) {
      const Meeting& meeting = meetings_[m];
      if (!held.contains(meeting.a == region ? meeting.b : meeting.a)) rim += meeting.border;
    }
  }
  return rim.edges > 0.0 ? rim.bend() : 1.0;
}

double SurfaceRegions::seam(std::span<const Index> points) const {
  Held held = held_by(points);
  RegionJoiner joiner(std::move(held.counts), static_cast<std::size_t>(options_.fragment));
  for (const Index region : held.regions) {
    for (const Index m : meetings_of_[region]) {
      const Meeting& meeting = meetings_[m];
      if (meeting.a == region && held.contains(meeting.b))
        joiner.add_border(held.place[region], held.place[meeting.b], meeting.border);
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
