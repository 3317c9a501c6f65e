#include "held_object.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace symscene {
namespace {

constexpr double group_edge = 0.04;  // [m]

void take_table(const Plane& table, const Eigen::Vector3d& point, double depth,
                ObstacleDistance& least) {
  const double height = table.signed_distance(point) + depth;
  if (height < least.distance) least = {height, ObstacleKind::table, -1};
}

}  // namespace

HeldObject::HeldObject(const std::vector<Eigen::Vector3d>& points) {
  std::map<std::array<int, 3>, Group> by_cube;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Array3i cube = (point / group_edge).array().floor().cast<int>();
    by_cube[{cube.x(), cube.y(), cube.z()}].points.push_back(point);
    extent_ = std::max(extent_, point.norm());
  }
  for (auto& [cube, group] : by_cube) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& point : group.points) box.extend(point);
    group.centre = box.center();
    for (const Eigen::Vector3d& point : group.points)
      group.radius = std::max(group.radius, (point - group.centre).norm());
    groups_.push_back(std::move(group));
  }
}

ObstacleDistance HeldObject::nearest(const MotionObstacles& obstacles,
                                     const Eigen::Isometry3d& T_world_tip,
                                     const IgnoredObstacles& ignored, double table_depth) const {
  ObstacleDistance least{MotionObstacles::near};
  // The table first: it is cheap, and the object mostly stands on it.
  if (obstacles.table()) {
    for (const Group& group : groups_) {
      for (const Eigen::Vector3d& point : group.points)
        take_table(*obstacles.table(), T_world_tip * point, table_depth, least);
    }
  }
  for (const Group& group : groups_) {
    const Eigen::Vector3d centre = T_world_tip * group.centre;
    if (obstacles.bound_at(centre) - group.radius >= least.distance) continue;
    if (!obstacles.nearest(Capsule{centre, centre, group.radius}, ignored, least.distance))
      continue;
    for (const Eigen::Vector3d& point : group.points) {
      const Eigen::Vector3d p = T_world_tip * point;
      if (const auto found = obstacles.nearest(Capsule{p, p, 0.0}, ignored, least.distance))
        least = *found;
    }
  }
  return least;
}

}  // namespace symscene
