#include "unseen_cubes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

  std::vector<UnseenCube> unseen(const std::optional<Plane>& table, int others, float reach) const {
    std::vector<UnseenCube> cubes;
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
      const Eigen::Vector3i cube = cube_at(i);
      UnseenCube unseen;
      unseen.centre = grid_.frame.origin + edge() * (cube.cast<float>().array() + 0.5F).matrix();
      const bool is_low =
          table && table->signed_distance(unseen.centre.cast<double>()) < 1.5 * double{edge()};
      if (is_low || has_free_voxel(cube, unseen.is_occupied)) continue;
      const auto [owner, squared] = nearest_[i];
      const float distance = owner == NearestOwner::nobody
                                 ? std::numeric_limits<float>::infinity()
                                 : edge() * std::sqrt(static_cast<float>(squared));
      if (unseen.is_occupied && distance <= known_surface) continue;
      if (owner != others && distance <= reach) unseen.object = static_cast<std::int16_t>(owner);
      cubes.push_back(unseen);
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

}  // namespace

std::vector<UnseenCube> unseen_cubes(const OccupancyGrid& grid,
                                     const std::vector<std::vector<Eigen::Vector3f>>& surfaces,
                                     const std::optional<Plane>& table, float reach, float& edge) {
  const CubeGrid cubes(grid, surfaces, reach);
  edge = cubes.edge();
  return cubes.unseen(table, static_cast<int>(surfaces.size()) - 1, reach);
}

}  // namespace symscene
