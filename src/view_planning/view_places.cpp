#include "view_places.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/spacing.hpp"
#include "core/surface_sampling.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

/// Inferred surface counts as explained within this distance of an image of observed points, or
/// within 1.5 spacings of the cloud. [m]
constexpr float least_image_reach = 0.0075F;
constexpr float off_surface = 1.5F;  // voxels between a place and its surface

/// Whether a triangle faces the table from no farther than `reach`: no camera sees it. [m]
bool rests_on(const std::optional<Plane>& table, const TriangleMesh& mesh, Eigen::Index triangle,
              double reach) {
  if (!table) return false;
  const auto corner = [&](int k) -> Eigen::Vector3d {
    return mesh.vertices.row(mesh.triangles(triangle, k)).transpose().cast<double>();
  };
  const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
  if (normal.dot(table->normal) >= 0.0) return false;
  return table->signed_distance(corner(0)) < reach && table->signed_distance(corner(1)) < reach &&
         table->signed_distance(corner(2)) < reach;
}

/// The triangles of a mesh that are wanted, by their number.
template <class IsWanted>
TriangleMesh part_of(const TriangleMesh& mesh, const IsWanted& is_wanted) {
  TriangleMesh part;
  part.vertices = mesh.vertices;
  std::vector<Eigen::Index> triangles;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    if (is_wanted(t)) triangles.push_back(t);
  }
  part.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t k = 0; k < triangles.size(); ++k)
    part.triangles.row(static_cast<Eigen::Index>(k)) = mesh.triangles.row(triangles[k]);
  return part;
}

/// Whether a place of an object is the image of what was seen of it.
class Explained {
 public:
  Explained(const PointCloud& images, float reach) : reach_(reach) {
    if (!images.empty()) cells_.emplace(images.positions, reach);
  }
  bool holds(const Eigen::Vector3f& place) const {
    return cells_ && cells_->nearest(place, reach_).first != CellList::none;
  }

 private:
  float reach_;  ///< [m]
  std::optional<CellList> cells_;
};

/// Collects the places of a scene.
class PlaceFinder {
 public:
  PlaceFinder(const KnownScene& scene, const ViewSpace& space, const NextViewOptions& options)
      : scene_(scene),
        space_(space),
        options_(options),
        spacing_(median_spacing(scene.result.cloud.positions).value_or(0.0F)) {
    for (const ObjectSurface& surface : scene.result.surfaces) add_surface(surface);
  }

  ViewPlaces find() {
    for (std::size_t i = 0; i < parts_.size(); ++i) add_inferred(i);
    add_disputed();
    if (space_.knows_space()) add_unknown();
    return std::move(places_);
  }

 private:
  void add_surface(const ObjectSurface& surface) {
    const double reach = 2.0 * static_cast<double>(space_.grid().frame.resolution);
    const auto is_visible = [&](Eigen::Index t) {
      return !rests_on(scene_.result.table, surface.mesh, t, reach);
    };
    parts_.push_back(part_of(surface.mesh, [&](Eigen::Index t) {
      return surface.observed[static_cast<std::size_t>(t)] == 0 && is_visible(t);
    }));
    areas_.push_back(surface_area(parts_.back()));
    places_.areas.push_back({areas_.back(), surface_area(part_of(surface.mesh, is_visible))});
    places_.object_area += places_.areas.back().all;
    places_.inferred_area += places_.areas.back().inferred;
  }

  float offset() const { return off_surface * space_.grid().frame.resolution; }

  void add_inferred(std::size_t object) {
    const double share = areas_[object] / std::max(places_.inferred_area, 1e-12);
    const auto count =
        static_cast<std::size_t>(std::ceil(share * static_cast<double>(options_.samples)));
    if (areas_[object] <= 0.0 || count == 0) return;
    const PointCloud samples = sample_surface(parts_[object], count);
    static const PointCloud no_images;
    const Explained explained(
        scene_.result.completed.empty() ? no_images : scene_.result.completed[object],
        std::max(least_image_reach, 1.5F * spacing_));
    const double belief = scene_.result.objects[object].rank();
    const double area = areas_[object] / static_cast<double>(samples.size());
    for (Index i = 0; i < samples.size(); ++i) {
      const Eigen::Vector3f at = samples.position(i), normal = samples.normal(i);
      const double weight = explained.holds(at) ? options_.explained_weight : 1.0;
      places_.inferred.push_back({at + offset() * normal, normal, belief * weight * area});
    }
  }

  /// Points that a rejected hypothesis joins with or takes from an object, weighted by how near it
  /// came to its bound.
  void add_disputed() {
    const PointCloud& cloud = scene_.result.cloud;
    std::vector<double> doubt(cloud.size(), 0.0);
    std::vector<int> owner(cloud.size(), -1);
    for (std::size_t k = 0; k < scene_.result.objects.size(); ++k) {
      for (const Index i : scene_.result.objects[k].points) owner[i] = static_cast<int>(k);
    }
    for (const Rejection& rejected : scene_.result.rejected) add_doubt(rejected, owner, doubt);
    PointIndices places;
    for (Index i = 0; i < cloud.size(); ++i) {
      if (doubt[i] > 0.0) places.push_back(i);
    }
    const Index kept = static_cast<Index>(options_.samples);
    const double each =
        static_cast<double>(spacing_ * spacing_) *
        std::max(1.0, static_cast<double>(places.size()) / static_cast<double>(kept));
    const bool has_normals = cloud.normals.rows() == cloud.positions.rows();
    for (const Index k : evenly_spread(static_cast<Index>(places.size()), kept)) {
      const Index i = places[k];
      const Eigen::Vector3f normal =
          has_normals ? Eigen::Vector3f(cloud.normal(i)) : Eigen::Vector3f::Zero();
      places_.disputed.push_back({cloud.position(i) + offset() * normal, normal,
                                  options_.dispute_weight * doubt[i] * each});
    }
  }

  /// The part of a hypothesis that the object which shares most of it does not have, and the other
  /// way round.
  void add_doubt(const Rejection& rejected, const std::vector<int>& owner,
                 std::vector<double>& doubt) const {
    if (rejected.points.empty() || !(rejected.bound > 0.0) || !(rejected.value > 0.0)) return;
    // Some bounds are least, others greatest values.
    const double ratio = rejected.value / rejected.bound;
    const double near = std::min(ratio, 1.0 / ratio);
    std::vector<std::size_t> shared(scene_.result.objects.size(), 0);
    for (const Index i : rejected.points) {
      if (owner[i] >= 0) ++shared[static_cast<std::size_t>(owner[i])];
    }
    if (shared.empty()) return;
    const auto most = std::max_element(shared.begin(), shared.end());
    if (*most == 0) return;
    const PointIndices& object =
        scene_.result.objects[static_cast<std::size_t>(most - shared.begin())].points;
    PointIndices difference;
    std::set_symmetric_difference(object.begin(), object.end(), rejected.points.begin(),
                                  rejected.points.end(), std::back_inserter(difference));
    for (const Index i : difference) doubt[i] = std::max(doubt[i], near);
  }

  /// Never seen voxels beside free ones, above the table.
  void add_unknown() {
    const OccupancyGrid& grid = space_.grid();
    std::vector<std::size_t> border;
    for (std::size_t i = 0; i < grid.states.size(); ++i) {
      if (is_border(i)) border.push_back(i);
    }
    const double edge = grid.frame.resolution;
    places_.unknown_area = edge * edge * static_cast<double>(border.size());
    const Index kept = static_cast<Index>(options_.samples);
    const double each =
        edge * edge * std::max(1.0, static_cast<double>(border.size()) / static_cast<double>(kept));
    for (const Index k : evenly_spread(static_cast<Index>(border.size()), kept))
      places_.unknown.push_back(
          {centre_of(border[k]), Eigen::Vector3f::Zero(), options_.unknown_weight * each});
  }

  Eigen::Vector3f centre_of(std::size_t voxel) const {
    const VoxelFrame& frame = space_.grid().frame;
    const auto [x, y, z] = cell_of(frame, voxel);
    const Eigen::Array3f cell(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    return frame.origin + frame.resolution * (cell + 0.5F).matrix();
  }

  bool is_border(std::size_t voxel) const {
    const OccupancyGrid& grid = space_.grid();
    if (grid.states[voxel] != VoxelState::never_seen || space_.is_solid(voxel)) return false;
    const Eigen::Vector3d centre = centre_of(voxel).cast<double>();
    if (scene_.result.table && scene_.result.table->signed_distance(centre) < 0.0) return false;
    const VoxelFrame& frame = grid.frame;
    const auto is_free = [&](std::size_t other) { return grid.states[other] == VoxelState::free; };
    const auto [x, y, z] = cell_of(frame, voxel);
    return (x > 0 && is_free(voxel - 1)) || (x + 1 < frame.row_length() && is_free(voxel + 1)) ||
           (y > 0 && is_free(voxel - frame.row_length())) ||
           (y + 1 < static_cast<std::size_t>(frame.size.y()) &&
            is_free(voxel + frame.row_length())) ||
           (z > 0 && is_free(voxel - frame.slice_length())) ||
           (z + 1 < frame.slices() && is_free(voxel + frame.slice_length()));
  }

  const KnownScene& scene_;
  const ViewSpace& space_;
  const NextViewOptions& options_;
  float spacing_;                    ///< of the cloud's points [m]
  std::vector<TriangleMesh> parts_;  ///< per object: what is inferred of its surface
  std::vector<double> areas_;        ///< of these [m²]
  ViewPlaces places_;
};

}  // namespace

ViewPlaces view_places(const KnownScene& scene, const ViewSpace& space,
                       const NextViewOptions& options) {
  return PlaceFinder(scene, space, options).find();
}

}  // namespace symscene
