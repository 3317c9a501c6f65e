#include "occupancy_hits.hpp"

#include <algorithm>
#include <array>

#include "core/dispatch.hpp"
#include "core/parallel.hpp"

namespace symscene {
namespace {

constexpr std::size_t hit_rows_per_task = 16;

/// A row of pixels: the point of pixel u is origin + depth · (start + u · step), in voxels from an
/// anchor near the camera, so that floats are exact enough anywhere in the tree.
struct PixelRow {
  float origin[3];
  float start[3];
  float step[3];
  std::int32_t anchor[3];  ///< key of the voxel that coordinates count from
  float max_depth;         ///< [m]
};

/// Spreads 6 bits, two zero bits between.
inline std::uint32_t spread_six(std::uint32_t bits) {
  bits = (bits | (bits << 8)) & 0x300FU;
  bits = (bits | (bits << 4)) & 0x30C3U;
  return (bits | (bits << 2)) & 0x9249U;
}

/// The key along one axis of the voxel around a coordinate.
inline std::uint32_t key_at(float coordinate, std::int32_t anchor) {
  const auto cut = static_cast<std::int32_t>(coordinate);
  const std::int32_t below = coordinate < static_cast<float>(cut) ? 1 : 0;
  return static_cast<std::uint32_t>(cut - below + anchor);
}

/// Brick and voxel of each pixel's point; no_brick where there is none.
SYMSCENE_MULTIVERSION
void locate(const PixelRow& row, const float* depth, std::size_t width, BrickKey* bricks,
            std::uint32_t* voxels) {
  const PixelRow in = row;
  for (std::size_t u = 0; u < width; ++u) {
    const bool measured = (depth[u] > 0.0F) & (depth[u] <= in.max_depth);
    const float z = measured ? depth[u] : 0.0F;
    const auto column = static_cast<float>(static_cast<std::int32_t>(u));
    const std::uint32_t kx =
        key_at(in.origin[0] + z * (in.start[0] + column * in.step[0]), in.anchor[0]);
    const std::uint32_t ky =
        key_at(in.origin[1] + z * (in.start[1] + column * in.step[1]), in.anchor[1]);
    const std::uint32_t kz =
        key_at(in.origin[2] + z * (in.start[2] + column * in.step[2]), in.anchor[2]);
    const std::uint32_t brick = (kx >> 6U) | ((ky >> 6U) << 10U) | ((kz >> 6U) << 20U);
    const bool inside = measured & ((kx | ky | kz) < 65536U);
    bricks[u] = inside ? brick : no_brick;
    voxels[u] = spread_six(kx & 63U) | (spread_six(ky & 63U) << 1U) | (spread_six(kz & 63U) << 2U);
  }
}

/// The voxels that a task found, by brick. With noise, neighbouring pixels fall on both sides of a
/// brick's border in turn, so a small table remembers several bricks.
class FoundVoxels {
 public:
  FoundVoxels() { slots_.fill(0); }

  void add(BrickKey brick, std::uint32_t voxel) { lists_[place_of(brick)].voxels.push_back(voxel); }

  std::vector<FoundInBrick> lists() && { return std::move(lists_); }

 private:
  std::size_t place_of(BrickKey brick) {
    std::size_t& slot = slots_[(brick ^ (brick >> 8U) ^ (brick >> 16U)) % slots_.size()];
    if (slot < lists_.size() && lists_[slot].brick == brick) return slot;
    for (slot = 0; slot < lists_.size(); ++slot) {
      if (lists_[slot].brick == brick) return slot;
    }
    lists_.push_back({brick, {}});
    return slot;
  }

  std::array<std::size_t, 64> slots_;
  std::vector<FoundInBrick> lists_;
};

/// The transform and the frame that all tasks share.
class HitFinder {
 public:
  HitFinder(const DepthFrame& frame, const CameraIntrinsics& camera,
            const Eigen::Isometry3d& T_world_camera, const OccupancyVolumeOptions& options)
      : frame_(frame), camera_(camera), max_depth_(static_cast<float>(options.max_depth)) {
    voxel_from_camera_ = T_world_camera.linear() / options.resolution;
    const Eigen::Array3d position = T_world_camera.translation().array() / options.resolution;
    anchor_ = position.floor();
    origin_ = position - anchor_;
  }

  std::vector<FoundInBrick> find(std::size_t first_row, std::size_t last_row) const {
    std::vector<BrickKey> bricks(camera_.width);
    std::vector<std::uint32_t> voxels(camera_.width);
    FoundVoxels found;
    BrickKey brick = no_brick;
    std::uint32_t voxel = 0;
    for (std::size_t v = first_row; v < last_row; ++v) {
      locate(pixel_row(v), frame_.depth.data() + v * camera_.width, camera_.width, bricks.data(),
             voxels.data());
      for (std::size_t u = 0; u < camera_.width; ++u) {
        if (bricks[u] == no_brick || (bricks[u] == brick && voxels[u] == voxel)) continue;
        brick = bricks[u];
        voxel = voxels[u];
        found.add(brick, voxel);
      }
    }
    return std::move(found).lists();
  }

 private:
  PixelRow pixel_row(std::size_t v) const {
    const Eigen::Vector3d start = voxel_from_camera_ * camera_.ray(0.0, static_cast<double>(v));
    const Eigen::Vector3d step = voxel_from_camera_.col(0) / camera_.fx;
    PixelRow row{};
    for (int axis = 0; axis < 3; ++axis) {
      row.origin[axis] = static_cast<float>(origin_[axis]);
      row.start[axis] = static_cast<float>(start[axis]);
      row.step[axis] = static_cast<float>(step[axis]);
      row.anchor[axis] = static_cast<std::int32_t>(anchor_[axis]) + OccupancyMap::key_of_origin;
    }
    row.max_depth = max_depth_;
    return row;
  }

  const DepthFrame& frame_;
  const CameraIntrinsics& camera_;
  float max_depth_;
  Eigen::Matrix3d voxel_from_camera_;  ///< turns into the world and scales to voxels
  Eigen::Array3d anchor_;              ///< [voxels]
  Eigen::Array3d origin_;              ///< of the camera, from the anchor [voxels]
};

}  // namespace

OccupancyHits::OccupancyHits(const DepthFrame& frame, const CameraIntrinsics& camera,
                             const Eigen::Isometry3d& T_world_camera,
                             const OccupancyVolumeOptions& options) {
  const HitFinder finder(frame, camera, T_world_camera, options);
  found_.resize((camera.height + hit_rows_per_task - 1) / hit_rows_per_task);
  parallel_for_blocks(camera.height, hit_rows_per_task, [&](std::size_t begin, std::size_t end) {
    found_[begin / hit_rows_per_task] = finder.find(begin, end);
  });
  for (const std::vector<FoundInBrick>& task : found_) {
    for (const FoundInBrick& found : task) runs_.push_back({found.brick, found.voxels});
  }
  std::stable_sort(runs_.begin(), runs_.end(),
                   [](const BrickHits& a, const BrickHits& b) { return a.brick < b.brick; });
}

std::span<const BrickHits> OccupancyHits::in_brick(BrickKey brick) const {
  const auto [begin, end] =
      std::equal_range(runs_.begin(), runs_.end(), BrickHits{brick, {}},
                       [](const BrickHits& a, const BrickHits& b) { return a.brick < b.brick; });
  return {begin, end};
}

}  // namespace symscene
