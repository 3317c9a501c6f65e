#include "unseen_cubes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "free_columns.hpp"
#include "grasping/nearest_owner.hpp"

namespace symscene {
namespace {

constexpr float wanted_edge = 0.01F;    // [m]
constexpr float known_surface = 0.02F;  // [m]

/// The cubes of a grid and, of each, the nearest surface within reach.
class CubeGrid {
 public:
  CubeGrid(const OccupancyGrid& grid, const std::vector<std::vector<Eigen::Vector3f>>& surfaces,
           float reach)
      : grid_(grid),
        coarseness_(
            std::max(1, static_cast<int>(std::lround(wanted_edge / grid.frame.resolution)))),
        size_((grid.frame.size / coarseness_).cwiseMax(0)) {
    NearestOwner nearest(size_.array(), static_cast<int>(surfaces.size()));
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      for (const Eigen::Vector3f& point : surfaces[i]) {
        const Eigen::Array3i cube =
            ((point - grid.frame.origin) / edge()).array().floor().cast<int>();
        if ((cube >= 0).all() && (cube < size_.array()).all())
          nearest.claim(cube, static_cast<int>(i));
      }
    }
    nearest_ = nearest.nearest(static_cast<int>(std::max(reach, known_surface) / edge()));
  }

  float edge() const { return grid_.frame.resolution * static_cast<float>(coarseness_); }

  std::vector<UnseenCube> unseen(const std::optional<Plane>& table, double tallest, int others,
                                 float reach) const {
    std::vector<UnseenCube> cubes;
    std::optional<FreeColumns> columns;
    if (table) columns.emplace(*table, grid_.frame, edge(), tallest);
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
      UnseenCube cube;
      cube.centre = centre_of(i);
      if (has_free_voxel(cube_at(i), cube.is_occupied)) {
        if (columns) columns->add_free(cube.centre);
        continue;
      }
      const bool is_low =
          table && table->signed_distance(cube.centre.cast<double>()) < 1.5 * double{edge()};
      if (!is_low && assign(nearest_[i], others, reach, cube)) cubes.push_back(cube);
    }
    if (columns) {
      std::erase_if(cubes, [&](const UnseenCube& cube) {
        return !cube.is_occupied && !columns->may_hide(cube.centre);
      });
    }
    return cubes;
  }

 private:
  Eigen::Vector3i cube_at(std::size_t i) const {
    const auto row = static_cast<std::size_t>(size_.x());
    const auto slice = row * static_cast<std::size_t>(size_.y());
    return {static_cast<int>(i % row), static_cast<int>(i % slice / row),
            static_cast<int>(i / slice)};
  }

  Eigen::Vector3f centre_of(std::size_t i) const {
    return grid_.frame.origin + edge() * (cube_at(i).cast<float>().array() + 0.5F).matrix();
  }

  /// Sets the object of a cube; false if it is occupied by a known surface.
  bool assign(const NearestOwner::Claim& nearest, int others, float reach, UnseenCube& cube) const {
    const float distance = nearest.owner == NearestOwner::nobody
                               ? std::numeric_limits<float>::infinity()
                               : edge() * std::sqrt(static_cast<float>(nearest.squared_distance));
    if (cube.is_occupied && distance <= known_surface) return false;
    if (nearest.owner != others && distance <= reach)
      cube.object = static_cast<std::int16_t>(nearest.owner);
    return true;
  }

  bool has_free_voxel(const Eigen::Vector3i& cube, bool& is_occupied) const {
    const VoxelFrame& frame = grid_.frame;
    const Eigen::Vector3i low = cube * coarseness_;
    for (int z = low.z(); z < low.z() + coarseness_; ++z) {
      for (int y = low.y(); y < low.y() + coarseness_; ++y) {
        for (int x = low.x(); x < low.x() + coarseness_; ++x) {
          const VoxelState state = grid_.states[static_cast<std::size_t>(z) * frame.slice_length() +
                                                static_cast<std::size_t>(y) * frame.row_length() +
                                                static_cast<std::size_t>(x)];
          if (state == VoxelState::free) return true;
          is_occupied = is_occupied || state == VoxelState::occupied;
        }
      }
    }
    return false;
  }

  const OccupancyGrid& grid_;
  int coarseness_;
  Eigen::Vector3i size_;
  std::vector<NearestOwner::Claim> nearest_;
};

double tallest(const std::vector<std::vector<Eigen::Vector3f>>& surfaces, const Plane& table) {
  double height = 0.0;
  for (const std::vector<Eigen::Vector3f>& surface : surfaces) {
    for (const Eigen::Vector3f& point : surface)
      height = std::max(height, table.signed_distance(point.cast<double>()));
  }
  return height;
}

}  // namespace

std::vector<UnseenCube> unseen_cubes(const OccupancyGrid& grid,
                                     const std::vector<std::vector<Eigen::Vector3f>>& surfaces,
                                     const std::optional<Plane>& table, float reach, float& edge) {
  const CubeGrid cubes(grid, surfaces, reach);
  edge = cubes.edge();
  return cubes.unseen(table, table ? tallest(surfaces, *table) : 0.0,
                      static_cast<int>(surfaces.size()) - 1, reach);
}

}  // namespace symscene
