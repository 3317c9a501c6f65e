#include "segmentation/workspace.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/stray_points.hpp"
#include "core/voxel_sampling.hpp"
#include "occupancy/frame_checks.hpp"
#include "segmentation/occupancy_warning.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using Warnings = std::vector<std::string>;

/// Whether so many points of a cloud are left out that the result may suffer: more than 5 %.
bool is_notable(Index left_out, Index all) { return 20 * std::size_t{left_out} > all; }

/// Objects of a hundred points do not fit into fewer voxels than these, along the longest side.
constexpr float fewest_voxels = 10.0F;

void warn_of_tiny(const Points& positions, double voxel_size, Warnings& warnings) {
  const float extent = bounding_box(positions).extent().maxCoeff();
  if (extent >= fewest_voxels * static_cast<float>(voxel_size)) return;
  warnings.push_back(
      fmt::format("the cloud is only {:.2g} m large (are the units metres?)", extent));
}

PointCloud sample_cloud(const Scene& scene, const WorkspaceOptions& options, Warnings& warnings) {
  const PointCloud sampled = voxel_downsample(scene.cloud, options.voxel_size);
  if (sampled.empty()) {
    throw InputError("point cloud", "at least one point with finite coordinates",
                     fmt::format("{} points without any", scene.cloud.size()));
  }
  PointCloud cloud = select(sampled, points_with_neighbors(sampled.positions, options.stray_radius,
                                                           options.stray_neighbors));
  if (cloud.empty()) {
    throw InputError("point cloud",
                     fmt::format("points less than {} m apart", options.stray_radius),
                     fmt::format("{} points far from each other", sampled.size()));
  }
  warn_of_tiny(scene.cloud.positions, options.voxel_size, warnings);
  const Index stray = sampled.size() - cloud.size();
  if (is_notable(stray, sampled.size())) {
    warnings.push_back(
        fmt::format("{} of {} points are left out: they have fewer than {} others "
                    "within {} m",
                    stray, sampled.size(), options.stray_neighbors, options.stray_radius));
  }
  return cloud;
}

DistanceField space_around(const Scene& scene, const PointCloud& cloud,
                           const WorkspaceOptions& options, Warnings& warnings) {
  const Box box = bounding_box(cloud.positions).padded(static_cast<float>(options.space_margin));
  if (!scene.occupancy) {
    warnings.emplace_back(no_occupancy_warning);
    return unknown_distance_field(box, static_cast<float>(options.voxel_size), scene.table,
                                  options.distance_field);
  }
  const OccupancyGrid grid = rasterize(*scene.occupancy, box, options.distance_field.max_voxels);
  const double finest = scene.occupancy->resolution;
  if (double{grid.frame.resolution} > 1.5 * finest) {
    warnings.push_back(
        fmt::format("the scene is so large that its free space is taken in voxels of {:.3g} m "
                    "instead of {:.3g} m (distance_field.max_voxels)",
                    grid.frame.resolution, finest));
  }
  if (is_unobserved(grid)) {
    warnings.emplace_back(
        "the occupancy map has no observed voxel around the cloud: is it in the cloud's frame?");
  }
  return distance_field(grid, scene.table, options.distance_field);
}

/// Estimates normals if no point has one; drops points that have none.
void complete_normals(const Scene& scene, const WorkspaceOptions& options, Workspace& space) {
  PointCloud& cloud = space.cloud;
  if (oriented_points(cloud).empty()) {
    space.warnings.emplace_back(
        "the cloud has no usable normals: they are estimated from neighbouring points");
    cloud.normals = estimate_normals(cloud.positions,
                                     outward_vote(space.field, scene.table, options.outward_vote),
                                     options.normals);
  }
  const PointIndices oriented = oriented_points(cloud);
  if (oriented.empty())
    throw InputError("point cloud", "points with normals", "none that is usable");
  if (oriented.size() == cloud.size()) return;
  const Index without = cloud.size() - static_cast<Index>(oriented.size());
  if (is_notable(without, cloud.size())) {
    space.warnings.push_back(
        fmt::format("{} points without a usable normal are left out", without));
  }
  cloud = select(cloud, oriented);
}

}  // namespace

NeighborLists voxel_neighbors(const Points& points, double voxel_size) {
  return radius_neighbors(points, static_cast<float>(voxel_size * std::sqrt(3.0)));
}

Workspace sampled_workspace(const Scene& scene, const WorkspaceOptions& options,
                            StageTimer& timer) {
  Workspace space;
  space.warnings = scene.warnings;
  if (scene.table) space.up = scene.table->normal;
  space.cloud = timer.time("sampling", [&] {  // section 2.1.1
    return sample_cloud(scene, options, space.warnings);
  });
  space.field = timer.time("distance field", [&] {  // section 2.1.2
    return space_around(scene, space.cloud, options, space.warnings);
  });
  for (std::string& warning :
       frame_warnings(space.cloud.positions, space.field, scene.table, options.frame_tolerance))
    space.warnings.push_back(std::move(warning));
  timer.time("normals", [&] { complete_normals(scene, options, space); });
  return space;
}

Workspace build_workspace(const Scene& scene, const WorkspaceOptions& options, StageTimer& timer) {
  Workspace space = sampled_workspace(scene, options, timer);
  space.edges = timer.time("surface graph", [&] {  // section 4.3.2
    return surface_graph(space.cloud, options.surface_graph);
  });
  space.segments = timer.time("oversegmentation", [&] {  // section 3.5.1
    space.neighbors = voxel_neighbors(space.cloud.positions, options.voxel_size);
    return oversegment(space.cloud, space.neighbors, options.oversegmentation);
  });
  return space;
}

}  // namespace symscene
