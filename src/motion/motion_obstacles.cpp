#include "symscene/motion/motion_obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.hpp"
#include "segment_distance.hpp"
#include "surface_points.hpp"
#include "unseen_cubes.hpp"

namespace symscene {
namespace {

constexpr float point_spacing = 0.008F;  // of points on surfaces [m]
constexpr float point_radius = 0.003F;   // so that no gap between them is wider than 2 mm [m]
constexpr float cell_edge = 0.03F;       // [m]
constexpr float finest_field = 0.015F;   // edge of the field's voxels [m]
constexpr double field_reach = 0.16;     // 11 of the finest voxels [m]
constexpr float most_voxels = 4e6F;      // of the field; a larger space gets coarser ones

std::vector<Eigen::Vector3f> rows_of(const Points& points) {
  std::vector<Eigen::Vector3f> rows;
  for (Eigen::Index i = 0; i < points.rows(); ++i) rows.emplace_back(points.row(i).transpose());
  return one_per_cube(rows, 0.5F * point_spacing);
}

bool is_ignored(ObstacleKind kind, int object, const IgnoredObstacles& ignored) {
  if (object < 0) return false;
  return kind == ObstacleKind::object ? object == ignored.surface_of
                                      : object == ignored.never_seen_at;
}

}  // namespace

const char* to_string(ObstacleKind kind) {
  switch (kind) {
    case ObstacleKind::object:
      return "object";
    case ObstacleKind::surface:
      return "surface";
    case ObstacleKind::never_seen:
      return "never_seen";
    case ObstacleKind::table:
      return "table";
    case ObstacleKind::robot:
      return "robot";
  }
  return "";
}

MotionObstacles::MotionObstacles(const GraspScene& scene,
                                 const std::vector<Capsule>& robot_at_start,
                                 const MotionObstacleOptions& options)
    : table_(scene.table) {
  options.validate();
  std::vector<std::vector<Eigen::Vector3f>> surfaces(scene.objects.size() + 1);
  parallel_for_each(surfaces.size(), [&](std::size_t i) {
    surfaces[i] = i < scene.objects.size() ? surface_points(scene.objects[i], point_spacing)
                                           : rows_of(scene.obstacles);
  });
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const bool is_object = i < scene.objects.size();
    for (const Eigen::Vector3f& point : surfaces[i]) {
      balls_.push_back({point, point_radius,
                        static_cast<std::int16_t>(is_object ? static_cast<int>(i) : -1),
                        is_object ? ObstacleKind::object : ObstacleKind::surface});
    }
  }
  if (scene.space) add_space(*scene.space, surfaces, robot_at_start, options);
  sort_into_cells();
  make_field();
}

void MotionObstacles::add_space(const OccupancyGrid& space,
                                const std::vector<std::vector<Eigen::Vector3f>>& surfaces,
                                const std::vector<Capsule>& robot_at_start,
                                const MotionObstacleOptions& options) {
  float edge = 0.0F;
  const auto cubes =
      unseen_cubes(space, surfaces, table_, static_cast<float>(options.own_reach), edge);
  for (const UnseenCube& cube : cubes) {
    if (cube.is_occupied) {
      balls_.push_back({cube.centre, 0.5F * edge, -1, ObstacleKind::surface});
      continue;
    }
    if (!options.never_seen) continue;
    const Eigen::Vector3d centre = cube.centre.cast<double>();
    const bool is_robot =
        std::any_of(robot_at_start.begin(), robot_at_start.end(), [&](const Capsule& part) {
          return segment_distance(centre, part.begin, part.end) <
                 part.radius + options.start_clearance;
        });
    if (!is_robot)
      balls_.push_back({cube.centre, 0.5F * edge, cube.object, ObstacleKind::never_seen});
  }
}

std::size_t MotionObstacles::cell_index(const Eigen::Vector3i& cell) const {
  return (static_cast<std::size_t>(cell.z()) * static_cast<std::size_t>(size_.y()) +
          static_cast<std::size_t>(cell.y())) *
             static_cast<std::size_t>(size_.x()) +
         static_cast<std::size_t>(cell.x());
}

void MotionObstacles::sort_into_cells() {
  if (balls_.empty()) return;
  Box box;
  for (const Ball& ball : balls_) {
    greatest_radius_ = std::max(greatest_radius_, double{ball.radius});
    box.min = box.min.cwiseMin(ball.centre);
    box.max = box.max.cwiseMax(ball.centre);
  }
  origin_ = box.min;
  size_ = (box.extent() / cell_edge).array().floor().cast<int>() + 1;
  const auto index_of = [&](const Ball& ball) {
    const Eigen::Vector3i cell = ((ball.centre - origin_) / cell_edge).array().floor().cast<int>();
    return cell_index(cell.cwiseMin((size_.array() - 1).matrix()));
  };
  begins_.assign(static_cast<std::size_t>(size_.prod()) + 1, 0);
  for (const Ball& ball : balls_) ++begins_[index_of(ball) + 1];
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  std::vector<Ball> sorted(balls_.size());
  for (const Ball& ball : balls_) sorted[next[index_of(ball)]++] = ball;
  balls_ = std::move(sorted);
}

void MotionObstacles::make_field() {
  if (balls_.empty()) return;
  OccupancyGrid grid;
  float voxel_edge = finest_field;
  const Eigen::Array3f extent = cell_edge * size_.cast<float>().array();
  const auto voxels_along = [&] {
    return ((extent + 2.0F * (static_cast<float>(field_reach) + voxel_edge)) / voxel_edge).ceil();
  };
  while (voxels_along().prod() > most_voxels && voxel_edge < 0.05F) voxel_edge *= 2.0F;
  grid.frame.resolution = voxel_edge;
  grid.frame.origin = origin_.array() - static_cast<float>(field_reach) - voxel_edge;
  grid.frame.size = voxels_along().cast<int>();
  grid.states.assign(grid.frame.voxels(), VoxelState::free);
  for (const Ball& ball : balls_) {
    const Eigen::Vector3i voxel =
        ((ball.centre - grid.frame.origin) / voxel_edge).array().floor().cast<int>();
    grid.states[static_cast<std::size_t>(voxel.z()) * grid.frame.slice_length() +
                static_cast<std::size_t>(voxel.y()) * grid.frame.row_length() +
                static_cast<std::size_t>(voxel.x())] = VoxelState::occupied;
  }
  DistanceFieldOptions options;
  options.clamp = field_reach;
  options.grow_never_seen = false;
  field_ = distance_field(grid, std::nullopt, options);
}

double MotionObstacles::bound_at(const Eigen::Vector3d& point) const {
  if (!field_) return field_reach;
  // Both ends of the distance lie up to half a diagonal off the centres of their voxels.
  const double diagonal = 1.7321 * double{field_->frame.resolution};
  return double{field_->at(point.cast<float>())} - diagonal - greatest_radius_;
}

template <class Visit>
void MotionObstacles::visit_near(const Eigen::Vector3d& min, const Eigen::Vector3d& max,
                                 const Visit& visit) const {
  if (balls_.empty()) return;
  const Eigen::Array3f low = ((min.cast<float>() - origin_) / cell_edge).array().floor();
  const Eigen::Array3f high = ((max.cast<float>() - origin_) / cell_edge).array().floor();
  const Eigen::Array3f last = size_.cast<float>().array() - 1.0F;
  if ((high < 0.0F).any() || (low > last).any()) return;
  const Eigen::Array3i from = low.max(0.0F).cast<int>();
  const Eigen::Array3i to = high.min(last).cast<int>();
  for (int z = from.z(); z <= to.z(); ++z) {
    for (int y = from.y(); y <= to.y(); ++y) {
      const std::size_t row = cell_index({0, y, z});
      const auto begin = begins_[row + static_cast<std::size_t>(from.x())];
      const auto end = begins_[row + static_cast<std::size_t>(to.x()) + 1];
      for (std::uint32_t i = begin; i < end; ++i) visit(balls_[i]);
    }
  }
}

std::optional<ObstacleDistance> MotionObstacles::nearest(const Capsule& capsule,
                                                         const IgnoredObstacles& ignored,
                                                         double up_to) const {
  std::optional<ObstacleDistance> best;
  const double reach = capsule.radius + up_to + greatest_radius_;
  if (reach <= 0.0) return best;
  double least = up_to;
  visit_near(capsule.begin.cwiseMin(capsule.end).array() - reach,
             capsule.begin.cwiseMax(capsule.end).array() + reach, [&](const Ball& ball) {
               // A never-seen cube has no surface: what keeps clear of its middle only touches it.
               const double radius =
                   ball.kind == ObstacleKind::never_seen ? 0.0 : double{ball.radius};
               const double distance =
                   segment_distance(ball.centre.cast<double>(), capsule.begin, capsule.end) -
                   capsule.radius - radius;
               if (distance >= least || is_ignored(ball.kind, ball.object, ignored)) return;
               least = distance;
               best = {distance, ball.kind, ball.object};
             });
  return best;
}

std::optional<ObstacleDistance> MotionObstacles::nearest(const Eigen::AlignedBox3d& box,
                                                         const Eigen::Isometry3d& T_world_box,
                                                         const IgnoredObstacles& ignored) const {
  std::optional<ObstacleDistance> best;
  double least = near;
  const Eigen::Isometry3d T_box_world = T_world_box.inverse();
  const Eigen::Vector3d centre = T_world_box * box.center();
  const Eigen::Vector3d half =
      (T_world_box.linear().cwiseAbs() * (0.5 * box.sizes())).array() + near + greatest_radius_;
  visit_near(centre - half, centre + half, [&](const Ball& ball) {
    const Eigen::Vector3d outside =
        (T_box_world * ball.centre.cast<double>() - box.center()).cwiseAbs() - 0.5 * box.sizes();
    const double deepest = outside.maxCoeff();
    // Never-seen cubes touch the hand's way at its borders: only those deep in the hand count.
    const double radius =
        ball.kind == ObstacleKind::never_seen ? -double{ball.radius} : double{ball.radius};
    if (deepest - radius >= least) return;
    const double distance = (deepest <= 0.0 ? deepest : outside.cwiseMax(0.0).norm()) - radius;
    if (distance >= least || is_ignored(ball.kind, ball.object, ignored)) return;
    least = distance;
    best = {distance, ball.kind, ball.object};
  });
  return best;
}

}  // namespace symscene
