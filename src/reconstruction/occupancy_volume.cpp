#include "symscene/reconstruction/occupancy_volume.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "brick_update.hpp"
#include "core/parallel.hpp"
#include "occupancy_region.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr int bricks_per_axis = 1 << (octree_depth - brick_level);

void require_usable(const DepthFrame& frame, const CameraIntrinsics& camera,
                    const Eigen::Isometry3d& T_world_camera) {
  const auto refuse = [](const char* where, const char* expected, const std::string& found) {
    throw InputError(where, expected, found);
  };
  if (camera.width == 0 || camera.height == 0) {
    refuse("camera", "an image with pixels", fmt::format("{} x {}", camera.width, camera.height));
  }
  if (frame.depth.size() != camera.pixels()) {
    refuse("depth frame", "a depth for every pixel of the camera",
           fmt::format("{} for {} x {}", frame.depth.size(), camera.width, camera.height));
  }
  const bool usable = camera.fx > 0.0 && camera.fy > 0.0 && std::isfinite(camera.fx) &&
                      std::isfinite(camera.fy) && std::isfinite(camera.cx) &&
                      std::isfinite(camera.cy);
  if (!usable) {
    refuse("camera", "positive focal lengths and a principal point",
           fmt::format("fx {} fy {} cx {} cy {}", camera.fx, camera.fy, camera.cx, camera.cy));
  }
  const Eigen::Matrix3d rotation = T_world_camera.linear();
  const bool rigid = T_world_camera.matrix().allFinite() &&
                     (rotation * rotation.transpose()).isIdentity(1e-4) &&
                     T_world_camera.translation().cwiseAbs().maxCoeff() < 1e5;
  if (!rigid)
    refuse("camera's pose", "a rotation and a translation within 100 km", "another matrix");
}

}  // namespace

struct OccupancyVolume::Implementation {
  explicit Implementation(const OccupancyVolumeOptions& given) : options(given) {
    options.validate();
    const auto steps = [](double value) {
      return static_cast<int>(std::lround(value / log_odds_step));
    };
    model = {steps(options.hit), steps(options.miss), steps(options.min_log_odds),
             steps(options.max_log_odds)};
  }

  /// The keys along each axis of the bricks that a frame may see.
  struct BrickRange {
    Eigen::Array3i low;
    Eigen::Array3i high;
  };
  BrickRange bricks_in_view(const CameraIntrinsics& camera, const Eigen::Isometry3d& T_world_camera,
                            double reach) const {
    Eigen::Array3d low = T_world_camera.translation();
    Eigen::Array3d high = low;
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3d ray = camera.ray(corner % 2 == 0 ? -0.5 : camera.width - 0.5,
                                             corner / 2 == 0 ? -0.5 : camera.height - 0.5);
      const Eigen::Array3d end = T_world_camera * (reach * ray);
      low = low.min(end);
      high = high.max(end);
    }
    const double edge = options.resolution * (1 << brick_level);
    const auto brick = [&](const Eigen::Array3d& at) -> Eigen::Array3i {
      return ((at / edge).floor() + 0.5 * bricks_per_axis)
          .max(-1.0)
          .min(double{bricks_per_axis})
          .cast<int>();
    };
    return {brick(low).max(0), brick(high).min(bricks_per_axis - 1)};
  }

  /// The bricks that a frame looks into or hits, ascending.
  static std::vector<BrickKey> bricks_to_update(const OccupancyView& view,
                                                const OccupancyHits& hits,
                                                const BrickRange& range) {
    std::vector<BrickKey> keys;
    for (int z = range.low.z(); z <= range.high.z(); ++z) {
      for (int y = range.low.y(); y <= range.high.y(); ++y) {
        for (int x = range.low.x(); x <= range.high.x(); ++x) {
          const auto key = static_cast<BrickKey>(x | (y << 10) | (z << 20));
          const Eigen::Vector3f center = view.center_camera(first_voxel(key));
          if (view.look_at(center, brick_level) != Sight::none) keys.push_back(key);
        }
      }
    }
    for (const BrickHits& run : hits.runs()) keys.push_back(run.brick);
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
  }

  void integrate(const DepthFrame& frame, const CameraIntrinsics& camera,
                 const Eigen::Isometry3d& T_world_camera) {
    const OccupancyView view(frame, camera, T_world_camera, options);
    const OccupancyHits hits(frame, camera, T_world_camera, options);
    const std::vector<BrickKey> keys =
        bricks_to_update(view, hits, bricks_in_view(camera, T_world_camera, view.reach()));
    std::vector<OccupancyBrick*> updated(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) updated[i] = &bricks[keys[i]];
    parallel_for_each(keys.size(), [&](std::size_t i) {
      update_brick(*updated[i], keys[i], {view, hits, model});
    });
  }

  VoxelState label(LogOdds value) const {
    constexpr double rounding = 1e-9;
    if (value == unseen) return VoxelState::never_seen;
    const bool occupied = value * log_odds_step >= options.threshold - rounding;
    return occupied ? VoxelState::occupied : VoxelState::free;
  }

  using PlacedBrick = std::pair<std::uint64_t, const OccupancyBrick*>;

  /// The bricks in depth-first order, by the place of their first voxel.
  std::vector<PlacedBrick> ordered() const {
    std::vector<PlacedBrick> placed;
    for (const auto& [key, brick] : bricks) {
      placed.emplace_back(morton_code(first_voxel(key)), &brick);
    }
    std::sort(placed.begin(), placed.end());
    return placed;
  }

  /// The leaves of value_of(log-odds) in a region.
  template <class Value, class ValueOf, class MakeLeaf>
  auto leaves(const std::optional<OrientedBox>& region, Value nothing, const ValueOf& value_of,
              const MakeLeaf& make_leaf) const;

  OccupancyVolumeOptions options;
  LogOddsModel model;
  std::map<BrickKey, OccupancyBrick> bricks;
};

template <class Value, class ValueOf, class MakeLeaf>
auto OccupancyVolume::Implementation::leaves(const std::optional<OrientedBox>& region,
                                             Value nothing, const ValueOf& value_of,
                                             const MakeLeaf& make_leaf) const {
  const std::vector<PlacedBrick> placed = ordered();
  const RegionTest test(region, options.resolution);
  // Cubes are visited in depth-first order.
  auto next = placed.begin();
  const auto uniform = [&](std::uint64_t code, int level) -> std::optional<Value> {
    while (next != placed.end() && next->first + voxels_of(brick_level) <= code) ++next;
    if (next == placed.end() || next->first >= code + voxels_of(level)) return nothing;
    const Sight inside = test.inside(code, level);
    if (inside == Sight::none) return nothing;
    if (level > brick_level || inside == Sight::some) return std::nullopt;
    const OccupancyBrick& brick = *next->second;
    if (brick.is_uniform()) return value_of(brick.value());
    const std::uint64_t voxel = code - next->first;
    const std::size_t block = voxel / block_voxels;
    if (level <= block_level && brick.is_uniform(block)) return value_of(brick.value(block));
    if (level > 0) return std::nullopt;
    return value_of(brick.voxels(block)[voxel % block_voxels]);
  };
  return octree_leaves(nothing, uniform, make_leaf);
}

void OccupancyVolumeOptions::validate() const {
  check_fields(*this);
  require_option(max_depth <= 4000.0 * resolution, "max_depth", "a depth of up to 4000 voxels",
                 max_depth);
  require_option(free_margin < max_depth, "free_margin", "less than max_depth", free_margin);
  require_option(threshold > min_log_odds && threshold <= max_log_odds, "threshold",
                 "above min_log_odds and up to max_log_odds", threshold);
}

OccupancyVolume::OccupancyVolume(const OccupancyVolumeOptions& options)
    : implementation_(std::make_unique<Implementation>(options)) {}
OccupancyVolume::~OccupancyVolume() = default;
OccupancyVolume::OccupancyVolume(OccupancyVolume&&) noexcept = default;
OccupancyVolume& OccupancyVolume::operator=(OccupancyVolume&&) noexcept = default;

void OccupancyVolume::integrate(const DepthFrame& frame, const CameraIntrinsics& camera,
                                const Eigen::Isometry3d& T_world_camera) {
  require_usable(frame, camera, T_world_camera);
  implementation_->integrate(frame, camera, T_world_camera);
}

OccupancyMap OccupancyVolume::map(const std::optional<OrientedBox>& region) const {
  const OccupancyVolumeOptions& options = implementation_->options;
  const auto state = [&](LogOdds value) { return implementation_->label(value); };
  const auto leaf = [](std::uint64_t code, int level, VoxelState value) {
    return OccupancyLeaf{octree_key(code), static_cast<std::uint8_t>(level), value};
  };
  return {options.resolution, implementation_->leaves(region, VoxelState::never_seen, state, leaf)};
}

LogOddsMap OccupancyVolume::log_odds(const std::optional<OrientedBox>& region) const {
  const auto same = [](LogOdds value) { return value; };
  const auto leaf = [](std::uint64_t code, int level, LogOdds value) {
    return LogOddsLeaf{octree_key(code), static_cast<std::uint8_t>(level),
                       static_cast<float>(value * log_odds_step)};
  };
  return {implementation_->options.resolution, implementation_->leaves(region, unseen, same, leaf)};
}

VoxelState OccupancyVolume::at(const Eigen::Vector3d& point_world) const {
  const Eigen::Array3d cell = (point_world.array() / implementation_->options.resolution).floor() +
                              OccupancyMap::key_of_origin;
  if (!(cell >= 0.0).all() || !(cell < 65536.0).all()) return VoxelState::never_seen;
  OctreeKey key{};
  for (int axis = 0; axis < 3; ++axis) {
    key[static_cast<std::size_t>(axis)] = static_cast<std::uint16_t>(cell[axis]);
  }
  const auto found = implementation_->bricks.find(brick_of(key));
  if (found == implementation_->bricks.end()) return VoxelState::never_seen;
  const std::uint64_t voxel = morton_code(key) & (voxels_of(brick_level) - 1);
  const std::size_t block = voxel / block_voxels;
  const LogOdds value = found->second.is_uniform(block)
                            ? found->second.value(block)
                            : found->second.voxels(block)[voxel % block_voxels];
  return implementation_->label(value);
}

std::size_t OccupancyVolume::memory() const {
  std::size_t bytes = 0;
  for (const auto& [key, brick] : implementation_->bricks) bytes += brick.memory();
  return bytes;
}

}  // namespace symscene
