#include "object_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "core/as_rows.hpp"

namespace symscene {
namespace {

constexpr Index sampled_normals = 64;      // directions of the convex bound
constexpr std::size_t lowest_share = 100;  // one point in so many may be a stray one
constexpr float layer_above_base = 0.4F;   // of the spacing of nodes

std::vector<Eigen::Vector3f> bound_directions(const SurfacePoints& points,
                                              const std::optional<Plane>& table) {
  std::vector<Eigen::Vector3f> directions;
  for (const Index i : evenly_spread(static_cast<Index>(points.size()), sampled_normals))
    directions.push_back(points.normals[i]);
  if (table) {
    directions.push_back(table->normal.cast<float>());
    directions.push_back(-directions.back());
  }
  return directions;
}

/// The height over the table at which an object ends: that of the table, or of its lowest points
/// if these are far above it. [m]
double height_of_base(const SurfacePoints& points, const Plane& table, double max_gap) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < points.observed; ++i)
    heights.push_back(table.signed_distance(points.positions[i].cast<double>()));
  const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / lowest_share);
  std::nth_element(heights.begin(), low, heights.end());
  return *low <= max_gap ? 0.0 : *low;
}

/// The points and, where there is a table, their projections onto the object's base.
Points with_projections(const SurfacePoints& points, const std::optional<Plane>& table,
                        double max_gap) {
  std::vector<Eigen::Vector3f> all = points.positions;
  if (table && points.observed != 0) {
    const double base = height_of_base(points, *table, max_gap);
    for (const Eigen::Vector3f& point : points.positions) {
      const double height = table->signed_distance(point.cast<double>()) - base;
      if (height > 0.0) all.push_back(point - (height * table->normal).cast<float>());
    }
  }
  return as_rows(all);
}

/// Nodes around a box, with a margin in which the surface ends. A layer of nodes lies just above
/// the base, so that a thin floor holds nodes.
NodeGrid grid_around(const Box& box, float base, float thickness,
                     const ObjectSurfaceOptions& options) {
  const auto voxel = static_cast<float>(options.voxel_size);
  NodeGrid grid;
  grid.spacing = std::clamp(0.25F * thickness, 0.4F * voxel, voxel);
  const auto size_at = [&](float spacing) -> Eigen::Array3d {
    return (box.extent().array() / spacing).ceil().cast<double>() + 6.0;
  };
  while (size_at(grid.spacing).prod() > options.max_nodes) grid.spacing *= 1.05F;
  grid.size = size_at(grid.spacing).cast<int>().matrix();
  const Eigen::Vector3f covered = grid.spacing * (grid.size.array() - 1).cast<float>().matrix();
  grid.origin = 0.5F * (box.min + box.max - covered);
  const float layers = (base - grid.origin.z()) / grid.spacing + layer_above_base;
  grid.origin.z() += (layers - std::floor(layers)) * grid.spacing;
  return grid;
}

}  // namespace

ObjectLattice object_lattice(const SurfacePoints& points, const std::optional<Plane>& table,
                             const ObjectSurfaceOptions& options) {
  const Points held = with_projections(points, table, options.max_base_gap);
  ObjectLattice lattice{.grid = {},
                        .box = bounding_box(held),
                        .bound = ConvexBound(bound_directions(points, table), held),
                        .in_bound = {},
                        .nearest = {}};
  lattice.base = lattice.box.min.z();
  if (table) lattice.base = std::max(lattice.base, static_cast<float>(-table->offset));
  lattice.grid = grid_around(lattice.box, lattice.base, lattice.bound.least_width(), options);
  // Cells that are larger than the radius need more.
  lattice.reach = std::max(static_cast<float>(options.reach), 2.0F * lattice.grid.spacing);
  lattice.in_bound = lattice.bound.distances(lattice.grid, lattice.margin());
  lattice.nearest =
      nearest_points(lattice.grid, points, lattice.reach, lattice.in_bound, lattice.margin());
  return lattice;
}

}  // namespace symscene
