#include "symscene/occupancy/occupancy_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::size_t leaf_block = 1 << 14;
constexpr int max_halvings = 4;  // of the resolution

/// The voxels of a box, in the lattice whose voxel 0 begins at the world's origin.
struct LatticeBox {
  Eigen::Vector3i low;
  Eigen::Vector3i size;
};

/// None if the box is empty, has more voxels or leaves the map's voxels.
std::optional<LatticeBox> lattice_box(const Box& box, double resolution, double max_voxels) {
  const Eigen::Array3d low = (box.min.cast<double>().array() / resolution).floor();
  const Eigen::Array3d high = (box.max.cast<double>().array() / resolution).floor();
  const Eigen::Array3d size = high - low + 1.0;
  const bool usable = box.min.allFinite() && box.max.allFinite() && (size >= 1.0).all() &&
                      size.prod() <= max_voxels && (low >= -OccupancyMap::key_of_origin).all() &&
                      (high < OccupancyMap::key_of_origin).all();
  if (!usable) return std::nullopt;
  return LatticeBox{low.cast<int>().matrix(), size.cast<int>().matrix()};
}

/// The key of the voxel of twice the size around a voxel.
OctreeKey halved(const OctreeKey& key) {
  constexpr int quarter = OccupancyMap::key_of_origin / 2;
  OctreeKey half;
  for (std::size_t axis = 0; axis < 3; ++axis)
    half[axis] = static_cast<std::uint16_t>(key[axis] / 2 + quarter);
  return half;
}

/// The state of the voxel around sibling voxels, of which absent ones were never seen.
VoxelState joined(std::span<const OccupancyLeaf> siblings) {
  const auto count = [&](VoxelState state) {
    return std::count_if(siblings.begin(), siblings.end(),
                         [&](const OccupancyLeaf& leaf) { return leaf.state == state; });
  };
  if (count(VoxelState::occupied) > 0) return VoxelState::occupied;
  return count(VoxelState::free) == 8 ? VoxelState::free : VoxelState::never_seen;
}

/// The map in voxels of twice the size: occupied where one of the eight is, free where all are.
OccupancyMap halved(const OccupancyMap& map) {
  OccupancyMap coarse;
  coarse.resolution = 2.0 * map.resolution;
  for (std::size_t i = 0; i < map.leaves.size();) {
    const OccupancyLeaf& leaf = map.leaves[i];
    const OctreeKey key = halved(leaf.key);
    std::size_t end = i + 1;
    OccupancyLeaf half{key, static_cast<std::uint8_t>(std::max(int{leaf.level} - 1, 0)),
                       leaf.state};
    if (leaf.level == 0) {
      while (end < map.leaves.size() && map.leaves[end].level == 0 &&
             halved(map.leaves[end].key) == key)
        ++end;
      half.state = joined({&leaf, end - i});
    }
    if (half.state != VoxelState::never_seen) coarse.leaves.push_back(half);
    i = end;
  }
  return coarse;
}

[[noreturn]] void refuse(const Box& box, double resolution, int max_voxels) {
  const Eigen::Vector3f extent = box.extent();
  throw InputError(
      "scene",
      fmt::format("a box that at most {} voxels of {:.4g} m cover, within {:.4g} m of the origin "
                  "(are the units metres?)",
                  max_voxels, std::ldexp(resolution, max_halvings),
                  resolution * OccupancyMap::key_of_origin),
      fmt::format("a box of {:.4g} x {:.4g} x {:.4g} m", extent.x(), extent.y(), extent.z()));
}

/// Writes the part of a leaf that lies in the grid. Leaves are disjoint, so that any order gives
/// the same grid.
void fill(const OccupancyLeaf& leaf, const LatticeBox& box, OccupancyGrid& grid) {
  const int edge = 1 << leaf.level;
  Eigen::Vector3i begin;
  Eigen::Vector3i end;
  for (int axis = 0; axis < 3; ++axis) {
    const int low =
        int{leaf.key[static_cast<std::size_t>(axis)]} - OccupancyMap::key_of_origin - box.low[axis];
    begin[axis] = std::max(low, 0);
    end[axis] = std::min(low + edge, box.size[axis]);
    if (begin[axis] >= end[axis]) return;
  }
  const std::size_t row = grid.frame.row_length();
  for (int z = begin.z(); z < end.z(); ++z) {
    for (int y = begin.y(); y < end.y(); ++y) {
      const std::size_t start = static_cast<std::size_t>(z) * grid.frame.slice_length() +
                                static_cast<std::size_t>(y) * row +
                                static_cast<std::size_t>(begin.x());
      std::fill_n(grid.states.begin() + static_cast<std::ptrdiff_t>(start), end.x() - begin.x(),
                  leaf.state);
    }
  }
}

OccupancyGrid filled(const OccupancyMap& map, const LatticeBox& box) {
  OccupancyGrid grid;
  grid.frame.origin = (box.low.cast<double>() * map.resolution).cast<float>();
  grid.frame.resolution = static_cast<float>(map.resolution);
  grid.frame.size = box.size;
  grid.states.assign(grid.frame.voxels(), VoxelState::never_seen);
  parallel_for_blocks(map.leaves.size(), leaf_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) fill(map.leaves[i], box, grid);
  });
  return grid;
}

}  // namespace

OccupancyGrid rasterize(const OccupancyMap& map, const Box& box, int max_voxels) {
  if (const auto voxels = lattice_box(box, map.resolution, max_voxels)) return filled(map, *voxels);
  constexpr double any = std::numeric_limits<double>::infinity();
  if (!lattice_box(box, map.resolution, any)) refuse(box, map.resolution, max_voxels);
  OccupancyMap coarse = halved(map);
  for (int halvings = 1; halvings < max_halvings; ++halvings) {
    if (const auto voxels = lattice_box(box, coarse.resolution, max_voxels))
      return filled(coarse, *voxels);
    coarse = halved(coarse);
  }
  const auto voxels = lattice_box(box, coarse.resolution, max_voxels);
  if (!voxels) refuse(box, map.resolution, max_voxels);
  return filled(coarse, *voxels);
}

}  // namespace symscene
