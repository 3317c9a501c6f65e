#include "symscene/occupancy/occupancy_grid.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr double max_voxels = 1 << 28;
constexpr std::size_t leaf_block = 1 << 14;

/// The voxels of a box, in the lattice whose voxel 0 begins at the world's origin.
struct LatticeBox {
  Eigen::Vector3i low;
  Eigen::Vector3i size;
};

LatticeBox lattice_box(const Box& box, double resolution) {
  const Eigen::Array3d low = (box.min.cast<double>().array() / resolution).floor();
  const Eigen::Array3d high = (box.max.cast<double>().array() / resolution).floor();
  const Eigen::Array3d size = high - low + 1.0;
  const Eigen::Vector3f extent = box.extent();
  const bool usable = box.min.allFinite() && box.max.allFinite() && (size >= 1.0).all() &&
                      size.prod() <= max_voxels && (low >= -OccupancyMap::key_of_origin).all() &&
                      (high < OccupancyMap::key_of_origin).all();
  if (!usable) {
    throw InputError(
        "scene",
        fmt::format("a box that at most 2^28 voxels of {:.4g} m cover, within {:.4g} m "
                    "of the origin (are the units metres?)",
                    resolution, resolution * OccupancyMap::key_of_origin),
        fmt::format("a box of {:.4g} x {:.4g} x {:.4g} m", extent.x(), extent.y(), extent.z()));
  }
  return {low.cast<int>().matrix(), size.cast<int>().matrix()};
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

}  // namespace

OccupancyGrid rasterize(const OccupancyMap& map, const Box& box) {
  const LatticeBox voxels = lattice_box(box, map.resolution);
  OccupancyGrid grid;
  grid.frame.origin = (voxels.low.cast<double>() * map.resolution).cast<float>();
  grid.frame.resolution = static_cast<float>(map.resolution);
  grid.frame.size = voxels.size;
  grid.states.assign(grid.frame.voxels(), VoxelState::never_seen);
  parallel_for_blocks(map.leaves.size(), leaf_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) fill(map.leaves[i], voxels, grid);
  });
  return grid;
}

}  // namespace symscene
