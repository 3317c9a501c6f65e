#include "table_objects.hpp"

#include <algorithm>
#include <cmath>

#include "bent_plane.hpp"
#include "core/parallel.hpp"
#include "core/voxel_sampling.hpp"
#include "enclosed_floors.hpp"
#include "fragments.hpp"
#include "table_roughness.hpp"

namespace symscene {
namespace {

constexpr Index points_for_bend = 20000;

/// Whether a point is of a wall.
class WallTest {
 public:
  WallTest(const SupportPlane& wall, const SupportPlaneOptions& options)
      : frame_(wall.plane),
        outline_(outline_of(wall.outline, frame_)),
        distance_(options.inlier_distance),
        cosine_(std::cos(options.normal_angle)) {}

  bool holds(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const {
    return std::abs(frame_.plane().signed_distance(point)) < distance_ &&
           frame_.plane().normal.dot(normal) > cosine_ &&
           outline_.distance(frame_.within(point)) <= 0.0;
  }

 private:
  PlaneFrame frame_;
  ConvexOutline outline_;
  double distance_;
  double cosine_;
};

/// The indices below `size` that satisfy a condition, ascending.
template <class Condition>
PointIndices indices_where(Index size, const Condition& condition) {
  constexpr std::size_t block = 4096;
  std::vector<std::uint8_t> holds(size);
  parallel_for_blocks(size, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) holds[i] = condition(static_cast<Index>(i)) ? 1 : 0;
  });
  PointIndices indices;
  for (Index i = 0; i < size; ++i) {
    if (holds[i] != 0) indices.push_back(i);
  }
  return indices;
}

/// Drops fragments that are small or mostly off the table.
void drop_stray_fragments(TableObjects& objects, const PlaneFrame& frame,
                          const ConvexOutline& outline, const TableCropOptions& options) {
  const FragmentBounds bounds = bounds_for(objects.cloud.positions, options);
  const std::vector<Index> fragment = fragments_of(objects.cloud.positions, bounds.link);
  struct Size {
    std::size_t points = 0;
    std::size_t inside = 0;
  };
  std::vector<Size> sizes;
  for (Index i = 0; i < objects.cloud.size(); ++i) {
    if (fragment[i] >= sizes.size()) sizes.resize(fragment[i] + std::size_t{1});
    ++sizes[fragment[i]].points;
    const Eigen::Vector3d point = objects.cloud.position(i).cast<double>();
    sizes[fragment[i]].inside += outline.distance(frame.within(point)) < 0.0 ? 1 : 0;
  }
  const auto kept = [&](const Size& size) {
    return size.points >= bounds.least && 2 * size.inside >= size.points;
  };
  PointIndices points;
  for (Index i = 0; i < objects.cloud.size(); ++i) {
    if (kept(sizes[fragment[i]])) points.push_back(i);
  }
  objects.dropped_fragments =
      sizes.size() - static_cast<std::size_t>(std::count_if(sizes.begin(), sizes.end(), kept));
  objects.dropped_points = objects.cloud.size() - points.size();
  objects.cloud = select(objects.cloud, points);
}

/// The height from which points belong to objects.
struct Clearance {
  double everywhere = 0.0;  ///< at least [m]
  double sigmas = 0.0;      ///< of the roughness
  double most = 0.0;        ///< where the table is rough [m]
  const TableRoughness& roughness;

  double at(const Eigen::Vector2d& within) const {
    return std::max(everywhere, std::min(sigmas * roughness.at(within), most));
  }
};

/// Those of the points that are above the clearance or on the floor of what stands on the table.
PointIndices standing_points(const PointCloud& cloud, const PointIndices& points,
                             const BentPlane& surface, const Clearance& clearance, double cell) {
  std::vector<PlaneSample> samples(points.size());
  parallel_for_each(points.size(), [&](std::size_t k) {
    const Eigen::Vector3d point = cloud.position(points[k]).cast<double>();
    samples[k] = {surface.frame().within(point), surface.height(point)};
  });
  std::vector<std::uint8_t> stands(points.size(), 0);
  for (const std::size_t k : enclosed_floors(samples, clearance.everywhere, cell)) stands[k] = 1;
  PointIndices standing;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (stands[k] != 0 || samples[k].height > clearance.at(samples[k].within))
      standing.push_back(points[k]);
  }
  return standing;
}

}  // namespace

TableObjects objects_on(const PointCloud& cloud, const FoundPlanes& planes,
                        const TableSceneOptions& options) {
  options.validate();
  const TableCropOptions& crop = options.crop;
  const SupportPlane& table = planes.table;
  PointIndices some;
  for (const Index k : evenly_spread(static_cast<Index>(table.inliers.size()), points_for_bend))
    some.push_back(table.inliers[k]);
  const BentPlane surface =
      crop.follow_bend ? BentPlane(table.plane, planes.searched, some) : BentPlane(table.plane);
  const ConvexOutline outline = outline_of(table.outline, surface.frame());
  TableObjects objects;
  objects.clearance = std::clamp(crop.clearance_sigmas * surface.residual(planes.searched, some),
                                 crop.min_clearance, crop.max_clearance);
  std::vector<WallTest> walls;
  for (const SupportPlane& wall : planes.walls) walls.emplace_back(wall, options.plane);
  const auto is_over_table = [&](Index i) {
    const Eigen::Vector3d point = cloud.position(i).cast<double>();
    const double height = surface.height(point);  // NaN is over no table
    if (!(height > -objects.clearance && height < options.plane.max_height)) return false;
    if (!(outline.distance(surface.frame().within(point)) < crop.overhang)) return false;
    const Eigen::Vector3d normal = cloud.normal(i).cast<double>();
    return std::none_of(walls.begin(), walls.end(),
                        [&](const WallTest& wall) { return wall.holds(point, normal); });
  };
  const PointIndices over_table = indices_where(cloud.size(), is_over_table);
  const TableRoughness roughness(cloud, surface, outline, options.plane.max_height, crop);
  const PointIndices standing = standing_points(
      cloud, over_table, surface,
      {objects.clearance, crop.rough_clearance_sigmas, crop.max_rough_clearance, roughness},
      2.0 * crop.voxel_size);
  objects.cloud = voxel_downsample(select(cloud, standing), crop.voxel_size);
  drop_stray_fragments(objects, surface.frame(), outline, crop);
  return objects;
}

}  // namespace symscene
