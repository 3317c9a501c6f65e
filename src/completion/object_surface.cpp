#include "symscene/completion/object_surface.hpp"

#include <algorithm>

#include "core/perpendicular_planes.hpp"
#include "core/vertex_normals.hpp"
#include "object_frame.hpp"
#include "object_lattice.hpp"
#include "seen_empty_space.hpp"
#include "sign_components.hpp"
#include "slivers.hpp"
#include "symscene/core/oriented_box.hpp"
#include "thin_walls.hpp"
#include "zero_surface.hpp"

namespace symscene {
namespace {

std::optional<Plane> turned(const std::optional<Plane>& plane,
                            const Eigen::Matrix3d& R_target_source) {
  if (!plane) return std::nullopt;
  return Plane{R_target_source * plane->normal, plane->offset};
}

Box box_in_world(const Box& box_object, const Eigen::Matrix3d& R_world_object) {
  OrientedBox oriented;
  oriented.T_world_box.linear() = R_world_object;
  oriented.min = box_object.min.cast<double>();
  oriented.max = box_object.max.cast<double>();
  return world_bounds(oriented);
}

/// How far the nodes of a lattice are inside the table or space that is known to be empty.
class EmptySpace {
 public:
  EmptySpace(const SurroundingSpace& space, const SeenEmptySpace& seen_empty,
             const Eigen::Matrix3d& R_world_object, double image_tolerance)
      : space_(space),
        seen_empty_(seen_empty),
        R_world_object_(R_world_object.cast<float>()),
        image_tolerance_(
            std::max(static_cast<float>(image_tolerance), 1.5F * space.field.frame.resolution)) {}

  /// Negative where the object may be. Near observed points a voxel of seen empty
  /// space is allowed, as their positions are more exact, and its images do not count. [m]
  float depth(const Eigen::Vector3f& point_object, bool near_observed) const {
    const Eigen::Vector3f point = R_world_object_ * point_object;
    const float voxel = space_.field.frame.resolution;
    float depth = seen_empty_.depth(point) - (near_observed ? voxel : 0.5F * voxel);
    if (space_.table) {
      const double height = space_.table->signed_distance(point.cast<double>());
      depth = std::max(depth, static_cast<float>(-height));
    }
    if (near_observed || !seen_empty_.has_symmetries()) return depth;
    return std::max(depth, seen_empty_.image_depth(point) - image_tolerance_);
  }

 private:
  const SurroundingSpace& space_;
  const SeenEmptySpace& seen_empty_;
  Eigen::Matrix3f R_world_object_;
  float image_tolerance_;  ///< [m]
};

/// The field of an object, negative inside. [m]
std::vector<float> object_field(const ObjectLattice& lattice, const SurfacePoints& points,
                                const EmptySpace& empty, const ThinWallBounds& walls) {
  const NodeGrid& grid = lattice.grid;
  const NearestPoints& nearest = lattice.nearest;
  const std::vector<float> surface =
      signed_distances(grid, points, nearest, lattice.reach, lattice.margin());
  std::vector<float> field(grid.nodes());
  for_each_node(grid, [&](std::size_t node, int x, int y, int z) {
    field[node] = std::max(lattice.in_bound[node], surface[node]);
    if (grid.is_border(x, y, z)) field[node] = std::max(field[node], grid.spacing);
    if (field[node] >= grid.spacing) return;  // outside, whatever was seen there
    const bool near_observed = points.is_observed(nearest.point[node]) &&
                               nearest.squared_distance[node] <= lattice.reach * lattice.reach;
    field[node] = std::max(field[node], empty.depth(grid.position(x, y, z), near_observed));
  });
  if (const auto vessel = find_vessel(points, lattice.bound, walls)) {
    hollow_out(grid, *vessel, nearest, {surface, lattice.in_bound}, field);
  } else {
    remove_slivers(grid, nearest, lattice.reach, field);
  }
  return field;
}

/// At least a cell and a half, as coarser cells cut deeper into curved surfaces. [m]
float observed_reach(const ObjectSurfaceOptions& options, const NodeGrid& grid) {
  return std::max(static_cast<float>(options.observed_reach), 1.5F * grid.spacing);
}

/// Whether each triangle was observed: at least two of its corners are near observed points.
std::vector<std::uint8_t> observed_triangles(const ZeroSurface& surface,
                                             const SurfacePoints& points,
                                             const NearestPoints& nearest, float reach) {
  std::vector<std::uint8_t> near(surface.nodes.size());
  for (std::size_t v = 0; v < near.size(); ++v) {
    const Index i = nearest.point[surface.nodes[v]];
    const Eigen::Vector3f vertex =
        surface.mesh.vertices.row(static_cast<Eigen::Index>(v)).transpose();
    const bool is_near = points.is_observed(i) && (vertex - points.positions[i]).norm() <= reach;
    near[v] = is_near ? 1 : 0;
  }
  std::vector<std::uint8_t> observed;
  for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
    int corners = 0;
    for (Eigen::Index k = 0; k < 3; ++k) corners += near[surface.mesh.triangles(t, k)];
    observed.push_back(corners >= 2 ? 1 : 0);
  }
  return observed;
}

}  // namespace

ObjectSurface object_surface(const CompletedObject& object, const SurroundingSpace& space,
                             const ObjectSurfaceOptions& options,
                             const CompletionOptions& completion) {
  options.validate();
  completion.validate();
  SurfacePoints points_world = surface_points(object.observed, object.added);
  if (points_world.size() == 0) return {};
  const Eigen::Matrix3d R_world_object = object_frame(points_world, space.table);
  const SurfacePoints points = turned(std::move(points_world), R_world_object.transpose());
  const ObjectLattice lattice =
      object_lattice(points, turned(space.table, R_world_object.transpose()), options);
  const SeenEmptySpace seen_empty(space.field, object.axes,
                                  perpendicular_planes(object.planes, completion.square_tolerance),
                                  box_in_world(lattice.box, R_world_object));
  const auto max_wall = static_cast<float>(options.max_wall);
  std::vector<float> field =
      object_field(lattice, points, {space, seen_empty, R_world_object, options.image_tolerance},
                   {max_wall, static_cast<float>(options.min_cavity), lattice.base + max_wall});
  remove_small_pieces(lattice.grid, options.min_piece, field);
  fill_pockets(lattice.grid, field);
  ZeroSurface surface = zero_surface(lattice.grid, field);
  std::vector<std::uint8_t> observed =
      observed_triangles(surface, points, lattice.nearest, observed_reach(options, lattice.grid));
  surface.mesh.vertices *= R_world_object.transpose().cast<float>();
  surface.mesh.normals = vertex_normals(surface.mesh);
  return {std::move(surface.mesh), std::move(observed)};
}

}  // namespace symscene
