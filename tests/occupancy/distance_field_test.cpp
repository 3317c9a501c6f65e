#include "symscene/occupancy/distance_field.hpp"

#include <random>

#include <gtest/gtest.h>

#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

OccupancyGrid random_grid(std::uint32_t seed, const Eigen::Vector3i& size) {
  std::mt19937 generator(seed);
  OccupancyGrid grid;
  grid.frame.origin = {-0.1F, 0.2F, 0.05F};
  grid.frame.size = size;
  grid.states.resize(grid.frame.voxels());
  for (VoxelState& state : grid.states) {
    const auto roll = generator() % 100;
    state = roll == 0   ? VoxelState::occupied
            : roll == 1 ? VoxelState::never_seen
                        : VoxelState::free;
  }
  return grid;
}

/// The obstacles by their definition, voxel by voxel.
class Obstacles {
 public:
  Obstacles(const OccupancyGrid& grid, const std::optional<Plane>& table, bool grow)
      : grid_(grid), table_(table), grow_(grow) {}

  bool at(const Eigen::Vector3i& v) const {
    if (state(v) != VoxelState::free || height(v) < 0.0) return true;
    if (!grow_) return false;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 1}) {
        Eigen::Vector3i beside = v;
        beside[axis] += step;
        if (inside(beside) && state(beside) == VoxelState::never_seen) return true;
      }
    }
    return false;
  }

  /// Over the table, in voxels. [voxels]
  double height(const Eigen::Vector3i& v) const {
    if (!table_) return 1.0;
    const double resolution = double{grid_.frame.resolution};
    const Eigen::Vector3d centre = grid_.frame.origin.cast<double>() +
                                   resolution * (v.cast<double>() + Eigen::Vector3d::Constant(0.5));
    return table_->signed_distance(centre) / resolution;
  }

 private:
  bool inside(const Eigen::Vector3i& v) const {
    return (v.array() >= 0).all() && (v.array() < grid_.frame.size.array()).all();
  }
  VoxelState state(const Eigen::Vector3i& v) const {
    return grid_
        .states[(static_cast<std::size_t>(v.z()) * static_cast<std::size_t>(grid_.frame.size.y()) +
                 static_cast<std::size_t>(v.y())) *
                    grid_.frame.row_length() +
                static_cast<std::size_t>(v.x())];
  }

  const OccupancyGrid& grid_;
  const std::optional<Plane>& table_;
  bool grow_;
};

std::vector<std::uint8_t> brute_force(const OccupancyGrid& grid, const std::optional<Plane>& table,
                                      const DistanceFieldOptions& options) {
  const Obstacles obstacles(grid, table, options.grow_never_seen);
  std::vector<Eigen::Vector3i> places;
  std::vector<Eigen::Vector3i> all;
  for (int z = 0; z < grid.frame.size.z(); ++z) {
    for (int y = 0; y < grid.frame.size.y(); ++y) {
      for (int x = 0; x < grid.frame.size.x(); ++x) {
        all.emplace_back(x, y, z);
        if (obstacles.at(all.back())) places.push_back(all.back());
      }
    }
  }
  const int reach = static_cast<int>(std::lround(options.clamp / 0.005));
  const int clamp = reach * reach;
  std::vector<std::uint8_t> squared;
  for (const Eigen::Vector3i& voxel : all) {
    int least = clamp;
    for (const Eigen::Vector3i& place : places)
      least = std::min(least, (voxel - place).squaredNorm());
    const double depth = std::clamp(-obstacles.height(voxel), 0.0, double{options.clamp / 0.005});
    if (options.table_depth_counts && table)
      least = std::max(least, static_cast<int>(depth * depth + 0.5));
    squared.push_back(static_cast<std::uint8_t>(least));
  }
  return squared;
}

TEST(DistanceField, EqualsBruteForce) {
  const std::vector<Eigen::Vector3i> sizes{
      {19, 13, 17}, {1, 1, 1}, {40, 3, 2}, {2, 5, 31}, {64, 9, 9}};
  for (std::uint32_t seed = 0; seed < sizes.size(); ++seed) {
    const OccupancyGrid grid = random_grid(seed, sizes[seed]);
    for (const int clamp : {1, 3, 6, 11}) {
      for (const bool grow : {false, true}) {
        DistanceFieldOptions options;
        options.clamp = 0.005 * clamp;
        options.grow_never_seen = grow;
        const DistanceField field = distance_field(grid, std::nullopt, options);
        ASSERT_EQ(field.squared, brute_force(grid, std::nullopt, options))
            << "seed " << seed << " clamp " << clamp << " grow " << grow;
      }
    }
  }
}

TEST(DistanceField, TakesTheHalfSpaceUnderATiltedTableAsObstacle) {
  const OccupancyGrid grid = random_grid(11, {15, 14, 24});
  Plane table;
  table.normal = Eigen::Vector3d(0.2, -0.1, 1.0).normalized();
  table.offset = -0.11;
  for (const bool depth_counts : {false, true}) {
    DistanceFieldOptions options;
    options.table_depth_counts = depth_counts;
    const DistanceField field = distance_field(grid, table, options);
    ASSERT_EQ(field.squared, brute_force(grid, table, options)) << depth_counts;
  }
}

TEST(DistanceField, IsTheSameForAnyNumberOfThreads) {
  const OccupancyGrid grid = random_grid(5, {70, 61, 53});
  std::vector<std::vector<std::uint8_t>> fields;
  for (const std::size_t threads : {1U, 2U, 8U}) {
    fields.push_back(
        testing::with_threads(threads, [&] { return distance_field(grid, std::nullopt).squared; }));
  }
  EXPECT_EQ(fields[0], fields[1]);
  EXPECT_EQ(fields[0], fields[2]);
}

TEST(DistanceField, ReadsMetresAtPointsAndTheClampOutside) {
  OccupancyGrid grid;
  grid.frame.size = {8, 4, 4};
  grid.states.assign(grid.frame.voxels(), VoxelState::free);
  grid.states[0] = VoxelState::occupied;
  const DistanceField field = distance_field(grid, std::nullopt);
  EXPECT_EQ(field.at({0.0025F, 0.0025F, 0.0025F}), 0.0F);
  EXPECT_FLOAT_EQ(field.at({0.0125F, 0.0025F, 0.0025F}), 0.010F);
  EXPECT_FLOAT_EQ(field.at({0.0075F, 0.0075F, 0.0025F}), 0.005F * std::sqrt(2.0F));
  EXPECT_FLOAT_EQ(field.at({-0.001F, 0.0F, 0.0F}), 0.03F);
  EXPECT_FLOAT_EQ(field.at({0.041F, 0.0F, 0.0F}), 0.03F);
  EXPECT_FLOAT_EQ(field.at(Eigen::Vector3f::Constant(std::nanf(""))), 0.03F);
}

TEST(DistanceField, OfUnknownSpaceIsZeroAboveTheTable) {
  const Box box{Eigen::Vector3f::Zero(), Eigen::Vector3f::Constant(0.1F)};
  const DistanceField field = unknown_distance_field(box, 0.005F, std::nullopt);
  EXPECT_EQ(field.at({0.05F, 0.05F, 0.05F}), 0.0F);
  EXPECT_EQ(field.at({5.0F, 0.0F, 0.0F}), 0.0F);
}

TEST(DistanceField, RefusesAClampOfTooManyVoxels) {
  DistanceFieldOptions options;
  options.clamp = 0.06;
  EXPECT_THROW(distance_field(random_grid(1, {3, 3, 3}), std::nullopt, options), InputError);
}

TEST(Rasterize, PutsEveryLeafAtItsKeys) {
  OccupancyMap map;
  constexpr auto origin = static_cast<std::uint16_t>(OccupancyMap::key_of_origin);
  map.leaves = {
      {{origin, origin, origin}, 1, VoxelState::free},
      {{static_cast<std::uint16_t>(origin - 1), origin, origin}, 0, VoxelState::occupied}};
  const Box box{Eigen::Vector3f(-0.004F, 0.001F, 0.001F), Eigen::Vector3f(0.011F, 0.006F, 0.001F)};
  const OccupancyGrid grid = rasterize(map, box);
  EXPECT_EQ(grid.frame.size, Eigen::Vector3i(4, 2, 1));
  const auto never = VoxelState::never_seen;
  const auto free = VoxelState::free;
  EXPECT_EQ(grid.states, (std::vector<VoxelState>{VoxelState::occupied, free, free, never, never,
                                                  free, free, never}));
}

/// Free space around the origin with some occupied and some unseen voxels.
OccupancyMap random_map(std::uint32_t seed) {
  std::mt19937 generator(seed);
  VoxelBlock block{Eigen::Vector3i(-8, -8, -8), Eigen::Vector3i(16, 16, 16), {}};
  for (int k = 0; k < 16 * 16 * 16; ++k) {
    const auto roll = generator() % 200;
    block.states.push_back(roll == 99    ? VoxelState::occupied
                           : roll == 100 ? VoxelState::never_seen
                                         : VoxelState::free);
  }
  return to_octree(block, 0.005);
}

TEST(Rasterize, TakesCoarserVoxelsForALargeBoxFreeOnlyWhereAllOfTheirPartsAre) {
  const OccupancyMap map = random_map(3);
  const Box box{Eigen::Vector3f::Constant(-0.0399F), Eigen::Vector3f::Constant(0.0399F)};
  const OccupancyGrid fine = rasterize(map, box);
  const OccupancyGrid coarse = rasterize(map, box, 16 * 16 * 16 - 1);
  ASSERT_EQ(fine.frame.size, Eigen::Vector3i::Constant(16));
  ASSERT_EQ(coarse.frame.size, Eigen::Vector3i::Constant(8));
  EXPECT_FLOAT_EQ(coarse.frame.resolution, 0.01F);
  EXPECT_TRUE(coarse.frame.origin.isApprox(fine.frame.origin));
  std::array<int, 3> counts{};
  for (std::size_t k = 0; k < coarse.states.size(); ++k) {
    std::array<int, 3> parts{};
    for (std::size_t part = 0; part < 8; ++part) {
      const std::size_t x = 2 * (k % 8) + (part & 1), y = 2 * (k / 8 % 8) + (part >> 1 & 1);
      const std::size_t z = 2 * (k / 64) + (part >> 2);
      ++parts[static_cast<std::size_t>(fine.states[z * 256 + y * 16 + x])];
    }
    const VoxelState expected = parts[2] > 0    ? VoxelState::occupied
                                : parts[1] == 8 ? VoxelState::free
                                                : VoxelState::never_seen;
    EXPECT_EQ(coarse.states[k], expected) << k;
    ++counts[static_cast<std::size_t>(expected)];
  }
  for (const int count : counts) EXPECT_GT(count, 10);
  // Four times as coarse is coarser twice.
  const OccupancyGrid coarsest = rasterize(map, box, 64);
  EXPECT_EQ(coarsest.frame.size, Eigen::Vector3i::Constant(4));
}

TEST(Rasterize, RefusesBoxesOfTooManyVoxels) {
  const OccupancyMap map;
  const Box huge{Eigen::Vector3f::Constant(-50.0F), Eigen::Vector3f::Constant(50.0F)};
  const Box far_off{Eigen::Vector3f::Constant(1e8F), Eigen::Vector3f::Constant(1e8F)};
  EXPECT_THROW(rasterize(map, huge), InputError);
  EXPECT_THROW(rasterize(map, far_off), InputError);
  EXPECT_THROW(rasterize(map, Box{}), InputError);
}

}  // namespace
}  // namespace symscene
