#include "moved_occupancy.hpp"

namespace symscene::bench {
namespace {

/// The lowest and one past the highest voxel of a box, keys minus key_of_origin.
struct VoxelBox {
  Eigen::Vector3i low, end;

  bool contains(const Eigen::Vector3i& voxel) const {
    return (voxel.array() >= low.array()).all() && (voxel.array() < end.array()).all();
  }
  std::size_t index(const Eigen::Vector3i& voxel) const {
    const Eigen::Matrix<std::int64_t, 3, 1> at = (voxel - low).cast<std::int64_t>();
    const Eigen::Matrix<std::int64_t, 3, 1> size = (end - low).cast<std::int64_t>();
    return static_cast<std::size_t>(at.x() + size.x() * (at.y() + size.y() * at.z()));
  }
  std::size_t count() const { return static_cast<std::size_t>((end - low).cast<double>().prod()); }
};

VoxelBox box_around(const Points& points, double margin, double resolution) {
  const Eigen::Vector3d low = points.colwise().minCoeff().transpose().cast<double>();
  const Eigen::Vector3d high = points.colwise().maxCoeff().transpose().cast<double>();
  return {((low.array() - margin) / resolution).floor().cast<int>(),
          ((high.array() + margin) / resolution).ceil().cast<int>()};
}

/// Calls visit(voxel) for the voxels of a leaf inside the box.
template <class Visit>
void for_each_voxel(const OccupancyLeaf& leaf, const VoxelBox& box, const Visit& visit) {
  const Eigen::Vector3i key(leaf.key[0], leaf.key[1], leaf.key[2]);
  const Eigen::Vector3i first = key.array() - OccupancyMap::key_of_origin;
  const Eigen::Vector3i low = first.cwiseMax(box.low);
  const Eigen::Vector3i end = (first.array() + (1 << leaf.level)).matrix().cwiseMin(box.end);
  for (int z = low.z(); z < end.z(); ++z)
    for (int y = low.y(); y < end.y(); ++y)
      for (int x = low.x(); x < end.x(); ++x) visit(Eigen::Vector3i(x, y, z));
}

}  // namespace

Points moved_points(const Points& points, const Eigen::Affine3d& motion) {
  Points result(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    result.row(i) = (motion * points.row(i).transpose().cast<double>()).cast<float>();
  return result;
}

OccupancyMap moved_occupancy(const OccupancyMap& map, const Eigen::Affine3d& T_moved_world,
                             const Points& around, double margin) {
  const Eigen::Affine3d T_world_moved = T_moved_world.inverse();
  const VoxelBox source =
      box_around(moved_points(around, T_world_moved), 2.0 * margin, map.resolution);
  std::vector<VoxelState> states(source.count(), VoxelState::never_seen);
  for (const OccupancyLeaf& leaf : map.leaves)
    for_each_voxel(leaf, source,
                   [&](const Eigen::Vector3i& voxel) { states[source.index(voxel)] = leaf.state; });
  const VoxelBox target = box_around(around, margin, map.resolution);
  VoxelBlock block{target.low, target.end - target.low, {}};
  block.states.assign(target.count(), VoxelState::never_seen);
  const OccupancyLeaf whole{{0, 0, 0}, octree_depth, VoxelState::free};
  for_each_voxel(whole, target, [&](const Eigen::Vector3i& voxel) {
    const Eigen::Vector3d centre = map.resolution * (voxel.cast<double>().array() + 0.5);
    const Eigen::Vector3d from = T_world_moved * centre / map.resolution;
    const Eigen::Vector3i there = from.array().floor().cast<int>();
    if (source.contains(there)) block.states[target.index(voxel)] = states[source.index(there)];
  });
  return to_octree(block, map.resolution);
}

}  // namespace symscene::bench
