#include "workspace.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/log.hpp"
#include "core/parallel.hpp"
#include "core/voxel_sampling.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Flying pixels between the camera and the scene would stretch the space to be mapped.
PointCloud without_stray_points(const PointCloud& cloud, double radius) {
  constexpr std::size_t min_neighbors = 3;
  const CellList cells(cloud.positions, static_cast<float>(radius));
  std::vector<std::uint8_t> is_stray(cloud.size(), 0);
  parallel_for_blocks(cloud.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      std::size_t near = 0;  // with the point itself
      cells.for_each_within(cloud.position(i), static_cast<float>(radius),
                            [&](Index, float) { ++near; });
      is_stray[i] = near <= min_neighbors ? 1 : 0;
    }
  });
  PointIndices kept;
  for (Index i = 0; i < cloud.size(); ++i) {
    if (is_stray[i] == 0) kept.push_back(i);
  }
  return kept.size() == cloud.size() ? cloud : select(cloud, kept);
}

PointCloud sample_cloud(const Scene& scene, const PipelineOptions& options) {
  const PointCloud sampled = voxel_downsample(scene.cloud, options.voxel_size);
  if (sampled.empty()) {
    throw InputError("point cloud", "at least one point with finite coordinates",
                     fmt::format("{} points without any", scene.cloud.size()));
  }
  PointCloud cloud = without_stray_points(sampled, options.stray_radius);
  if (cloud.empty()) {
    throw InputError("point cloud",
                     fmt::format("points less than {} m apart", options.stray_radius),
                     fmt::format("{} points far from each other", sampled.size()));
  }
  if (cloud.size() != sampled.size()) {
    log(LogLevel::info, fmt::format("{} stray points are left out", sampled.size() - cloud.size()));
  }
  return cloud;
}

/// Frames that do not belong together leave nothing to find: say so.
void warn_of_mismatched_frames(const Scene& scene, const PointCloud& cloud,
                               const DistanceField& field) {
  constexpr float noise = 0.02F;
  std::size_t below = 0;
  std::size_t in_free_space = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f p = cloud.position(i);
    if (scene.table && scene.table->signed_distance(p.cast<double>()) < -double{noise}) {
      ++below;
    } else if (field.at(p) > noise) {
      ++in_free_space;
    }
  }
  if (2 * below > cloud.size()) {
    log(LogLevel::warning,
        "most points lie below the table: does its normal point up, and is it in the cloud's "
        "frame?");
  }
  if (2 * in_free_space > cloud.size()) {
    log(LogLevel::warning,
        "most points lie in space that the occupancy says is empty: is it in the cloud's frame?");
  }
}

DistanceField space_around(const Scene& scene, const PointCloud& cloud,
                           const PipelineOptions& options) {
  const Box box = bounding_box(cloud.positions).padded(static_cast<float>(options.space_margin));
  if (!scene.occupancy) {
    log(LogLevel::warning, "no occupancy: all space off the surface counts as never seen");
    return unknown_distance_field(box, static_cast<float>(options.voxel_size), scene.table,
                                  options.distance_field);
  }
  const OccupancyGrid grid = rasterize(*scene.occupancy, box);
  const bool nothing_known =
      std::all_of(grid.states.begin(), grid.states.end(),
                  [](VoxelState state) { return state == VoxelState::never_seen; });
  if (nothing_known) {
    log(LogLevel::warning,
        "the occupancy knows nothing of the space around the cloud: is it in the cloud's frame?");
  }
  return distance_field(grid, scene.table, options.distance_field);
}

/// Outwards is where space is free; where that is not known, away from the table.
OutwardVote outward_vote(const DistanceField& field, const std::optional<Plane>& table) {
  static constexpr float step = 0.02F;
  const Eigen::Vector3f up =
      table ? Eigen::Vector3f(table->normal.cast<float>()) : Eigen::Vector3f::UnitZ();
  return [&field, up](const Eigen::Vector3f& p, const Eigen::Vector3f& n) {
    const float freer = field.at(p + step * n) - field.at(p - step * n);
    return double{freer} + 1e-3 * double{n.dot(up)};
  };
}

/// Estimates normals if there are none; drops points that have none.
void complete_normals(const Scene& scene, const PipelineOptions& options,
                      const DistanceField& field, PointCloud& cloud) {
  if (oriented_points(cloud).empty()) {
    log(LogLevel::info, "no usable normals: estimated from neighbouring points");
    cloud.normals =
        estimate_normals(cloud.positions, outward_vote(field, scene.table), options.normals);
  }
  const PointIndices oriented = oriented_points(cloud);
  if (oriented.size() != cloud.size()) {
    const Index without = cloud.size() - static_cast<Index>(oriented.size());
    log(20 * without > cloud.size() ? LogLevel::warning : LogLevel::info,
        fmt::format("{} points without a usable normal are left out", without));
    cloud = select(cloud, oriented);
  }
  if (cloud.empty()) throw InputError("point cloud", "points with normals", "none that is usable");
}

constexpr Index removed = ~Index{0};

std::vector<Index> renumbered(std::size_t count, const PointIndices& kept) {
  std::vector<Index> place(count, removed);
  for (Index k = 0; k < kept.size(); ++k) place[kept[k]] = k;
  return place;
}

}  // namespace

Workspace build_workspace(const Scene& scene, const PipelineOptions& options, StageTimer& timer) {
  Workspace space;
  if (scene.table) space.up = scene.table->normal;
  space.cloud = timer.time("sampling", [&] { return sample_cloud(scene, options); });
  space.field =
      timer.time("distance field", [&] { return space_around(scene, space.cloud, options); });
  warn_of_mismatched_frames(scene, space.cloud, space.field);
  timer.time("normals", [&] { complete_normals(scene, options, space.field, space.cloud); });
  space.edges = timer.time("surface graph",
                           [&] { return surface_graph(space.cloud, options.surface_graph); });
  space.segments = timer.time("oversegmentation", [&] {
    const auto radius = static_cast<float>(options.voxel_size * std::sqrt(3.0));
    space.neighbors = radius_neighbors(space.cloud.positions, radius);
    return oversegment(space.cloud, space.neighbors, options.oversegmentation);
  });
  return space;
}

Remainder without_objects(const Workspace& space, const std::vector<Hypothesis>& cuts,
                          const PipelineOptions& options) {
  const HypothesisBounds& bounds = options.rotational_segmentation.bounds;
  std::vector<bool> covered(space.cloud.size(), false);
  for (const Hypothesis& cut : cuts) {
    if (judge(cut, bounds, "rotational") ||
        confidence(cut.scores, bounds) < options.min_removal_score)
      continue;
    for (const Index i : cut.points) covered[i] = true;
  }
  Remainder rest;
  for (Index i = 0; i < space.cloud.size(); ++i) {
    if (!covered[i]) rest.original.push_back(i);
  }
  const std::vector<Index> place = renumbered(space.cloud.size(), rest.original);
  rest.space.cloud = select(space.cloud, rest.original);
  rest.space.up = space.up;
  for (const WeightedEdge& edge : space.edges) {
    if (place[edge.a] != removed && place[edge.b] != removed) {
      rest.space.edges.push_back({place[edge.a], place[edge.b], edge.weight});
    }
  }
  for (const PointIndices& segment : space.segments) {
    PointIndices thinned;
    for (const Index i : segment) {
      if (place[i] != removed) thinned.push_back(place[i]);
    }
    if (thinned.size() >= static_cast<std::size_t>(options.oversegmentation.min_size))
      rest.space.segments.push_back(std::move(thinned));
  }
  return rest;
}

}  // namespace symscene
