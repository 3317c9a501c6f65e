#include "occupancy_region.hpp"

namespace symscene {

RegionTest::RegionTest(const std::optional<OrientedBox>& region, double resolution)
    : resolution_(resolution), bounded_(region.has_value()) {
  if (!bounded_) return;
  T_box_world_ = region->T_world_box.inverse();
  center_ = 0.5 * (region->min + region->max);
  half_ = 0.5 * (region->max - region->min);
}

Sight RegionTest::inside(std::uint64_t code, int level) const {
  if (!bounded_) return Sight::all;
  const OctreeKey key = octree_key(code);
  const double reach = 0.5 * ((1 << level) - 1) * resolution_;
  const Eigen::Array3d first(key[0], key[1], key[2]);
  const Eigen::Vector3d middle =
      (first - (OccupancyMap::key_of_origin - 0.5)) * resolution_ + reach;
  const Eigen::Array3d from_center = (T_box_world_ * middle - center_).cwiseAbs();
  const Eigen::Array3d reaches =
      T_box_world_.linear().cwiseAbs() * Eigen::Vector3d::Constant(reach);
  if ((from_center - reaches > half_.array()).any()) return Sight::none;
  return (from_center + reaches <= half_.array()).all() ? Sight::all : Sight::some;
}

}  // namespace symscene
