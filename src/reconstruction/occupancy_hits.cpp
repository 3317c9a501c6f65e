#include "reconstruction/occupancy_hits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reconstruction/occupancy_brick.hpp"
#include "symscene/core/dispatch.hpp"
#include "symscene/core/parallel.hpp"

namespace symscene {
namespace {

constexpr std::size_t rows_a_task = 16;

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

/// Brick and voxel of each pixel's point; no_brick where there is none.
SYMSCENE_MULTIVERSION
void locate(const PixelRow& row, const float* depth, std::size_t width, BrickKey* bricks,
            std::uint32_t* voxels) {
  const PixelRow in = row;
  for (std::size_t u = 0; u < width; ++u) {
    const float d = depth[u];
    const bool measured = d > 0.0F && d <= in.max_depth;
    const float z = measured ? d : 0.0F;
    const auto column = static_cast<float>(static_cast<std::int32_t>(u));
    const auto key = [&](int axis) {
      const float at = in.origin[axis] + z * (in.start[axis] + column * in.step[axis]);
      const auto cut = static_cast<std::int32_t>(at);
      const std::int32_t floor = cut - (at < static_cast<float>(cut) ? 1 : 0);
      return static_cast<std::uint32_t>(floor + in.anchor[axis]);
    };
    const std::uint32_t x = key(0), y = key(1), z_key = key(2);
    const bool inside = (x | y | z_key) < 65536U;
    bricks[u] =
        measured && inside ? (x >> 6U) | ((y >> 6U) << 10U) | ((z_key >> 6U) << 20U) : no_brick;
    voxels[u] = spread_six(x & 63U) | (spread_six(y & 63U) << 1U) | (spread_six(z_key & 63U) << 2U);
  }
}

/// Where the voxels of a run begin in the list of their task.
struct RunStart {
  BrickKey brick;
  std::size_t begin;
};

/// Everything that the tasks share.
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

  void find(std::size_t first_row, std::size_t last_row, std::vector<std::uint32_t>& found,
            std::vector<RunStart>& starts) const {
    std::vector<BrickKey> bricks(camera_.width);
    std::vector<std::uint32_t> voxels(camera_.width);
    BrickKey brick = no_brick;
    std::uint32_t voxel = 0;
    for (std::size_t v = first_row; v < last_row; ++v) {
      locate(pixel_row(v), frame_.depth.data() + v * camera_.width, camera_.width, bricks.data(),
             voxels.data());
      for (std::size_t u = 0; u < camera_.width; ++u) {
        if (bricks[u] == no_brick || (bricks[u] == brick && voxels[u] == voxel)) continue;
        if (bricks[u] != brick) starts.push_back({bricks[u], found.size()});
        brick = bricks[u];
        voxel = voxels[u];
        found.push_back(voxel);
      }
    }
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
  const std::size_t tasks = (camera.height + rows_a_task - 1) / rows_a_task;
  voxels_.resize(tasks);
  std::vector<std::vector<RunStart>> starts(tasks);
  parallel_for_blocks(camera.height, rows_a_task, [&](std::size_t begin, std::size_t end) {
    finder.find(begin, end, voxels_[begin / rows_a_task], starts[begin / rows_a_task]);
  });
  for (std::size_t task = 0; task < tasks; ++task) {
    const std::span<const std::uint32_t> all = voxels_[task];
    for (std::size_t k = 0; k < starts[task].size(); ++k) {
      const std::size_t begin = starts[task][k].begin;
      const std::size_t end = k + 1 < starts[task].size() ? starts[task][k + 1].begin : all.size();
      runs_.push_back({starts[task][k].brick, all.subspan(begin, end - begin)});
    }
  }
  std::stable_sort(runs_.begin(), runs_.end(),
                   [](const BrickHits& a, const BrickHits& b) { return a.brick < b.brick; });
}

}  // namespace symscene
