#include "unseen_cubes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace symscene {
namespace {

constexpr float wanted_edge = 0.01F;    // [m]
constexpr float known_surface = 0.02F;  // [m]
constexpr auto far_away = std::numeric_limits<std::uint16_t>::max();

/// The cubes of a grid and, of each, the nearest surface within reach.
class CubeGrid {
 public:
  CubeGrid(const OccupancyGrid& grid, float reach)
      : grid_(grid),
        coarseness_(
            std::max(1, static_cast<int>(std::lround(wanted_edge / grid.frame.resolution)))),
        size_(grid.frame.size / coarseness_),
        reach_(static_cast<int>(std::max(reach, known_surface) / edge())) {
    const auto count = static_cast<std::size_t>(std::max(0, size_.prod()));
    nearest_.assign(count, -1);
    squared_.assign(count, far_away);
  }

  float edge() const { return grid_.frame.resolution * static_cast<float>(coarseness_); }

  void claim(const std::vector<Eigen::Vector3f>& points, std::int16_t surface) {
    std::vector<std::size_t> centres;
    for (const Eigen::Vector3f& point : points) {
      const Eigen::Vector3i cube =
          ((point - grid_.frame.origin) / edge()).array().floor().cast<int>();
      if (contains(cube)) centres.push_back(index(cube));
    }
    std::sort(centres.begin(), centres.end());
    centres.erase(std::unique(centres.begin(), centres.end()), centres.end());
    for (const std::size_t centre : centres) claim_around(cube_at(centre), surface);
  }

  std::vector<UnseenCube> unseen(const std::optional<Plane>& table, std::int16_t others,
                                 float reach) const {
    std::vector<UnseenCube> cubes;
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
      const Eigen::Vector3i cube = cube_at(i);
      UnseenCube unseen;
      unseen.centre = grid_.frame.origin + edge() * (cube.cast<float>().array() + 0.5F).matrix();
      const bool is_low =
          table && table->signed_distance(unseen.centre.cast<double>()) < 1.5 * double{edge()};
      if (is_low || has_free_voxel(cube, unseen.is_occupied)) continue;
      const float distance = squared_[i] == far_away
                                 ? std::numeric_limits<float>::infinity()
                                 : edge() * std::sqrt(static_cast<float>(squared_[i]));
      if (unseen.is_occupied && distance <= known_surface) continue;
      if (nearest_[i] != others && distance <= reach) unseen.object = nearest_[i];
      cubes.push_back(unseen);
    }
    return cubes;
  }

 private:
  bool contains(const Eigen::Vector3i& cube) const {
    return (cube.array() >= 0).all() && (cube.array() < size_.array()).all();
  }
  std::size_t index(const Eigen::Vector3i& cube) const {
    return (static_cast<std::size_t>(cube.z()) * static_cast<std::size_t>(size_.y()) +
            static_cast<std::size_t>(cube.y())) *
               static_cast<std::size_t>(size_.x()) +
           static_cast<std::size_t>(cube.x());
  }
  Eigen::Vector3i cube_at(std::size_t i) const {
    const auto row = static_cast<std::size_t>(size_.x());
    const auto slice = row * static_cast<std::size_t>(size_.y());
    return {static_cast<int>(i % row), static_cast<int>(i % slice / row),
            static_cast<int>(i / slice)};
  }

  void claim_around(const Eigen::Vector3i& centre, std::int16_t surface) {
    for (int z = -reach_; z <= reach_; ++z) {
      for (int y = -reach_; y <= reach_; ++y) {
        for (int x = -reach_; x <= reach_; ++x) {
          const int squared = x * x + y * y + z * z;
          const Eigen::Vector3i cube = centre + Eigen::Vector3i(x, y, z);
          if (squared > reach_ * reach_ || !contains(cube)) continue;
          const std::size_t i = index(cube);
          if (squared >= squared_[i]) continue;
          squared_[i] = static_cast<std::uint16_t>(squared);
          nearest_[i] = surface;
        }
      }
    }
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
  int reach_;
  std::vector<std::int16_t> nearest_;
  std::vector<std::uint16_t> squared_;
};

}  // namespace

std::vector<UnseenCube> unseen_cubes(const OccupancyGrid& grid,
                                     const std::vector<std::vector<Eigen::Vector3f>>& surfaces,
                                     const std::optional<Plane>& table, float reach, float& edge) {
  CubeGrid cubes(grid, reach);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    cubes.claim(surfaces[i], static_cast<std::int16_t>(i));
  edge = cubes.edge();
  return cubes.unseen(table, static_cast<std::int16_t>(surfaces.size() - 1), reach);
}

}  // namespace symscene
