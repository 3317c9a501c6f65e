#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "simulation/frame_fusion.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// A frame with the depths that decide about voxels.
struct View {
  Eigen::Isometry3d T_camera_world;
  Eigen::Vector3d position;            ///< of the camera in the world [m]
  const std::vector<float>* measured;  ///< [m]
  std::vector<float> nearest;          ///< least depth of a pixel and its eight neighbours: a voxel
                               ///< beside an edge is not free because its pixel looks past it [m]
};

std::vector<float> nearest_of_neighbors(const SensorFrame& frame, const CameraIntrinsics& camera) {
  std::vector<float> nearest(frame.depth.size(), 0.0F);
  for (Index v = 1; v + 1 < camera.height; ++v) {
    for (Index u = 1; u + 1 < camera.width; ++u) {
      const std::size_t pixel = std::size_t{v} * camera.width + u;
      if (frame.depth[pixel] <= 0.0F) continue;
      float least = frame.depth[pixel];
      for (Index y = v - 1; y <= v + 1; ++y) {
        for (Index x = u - 1; x <= u + 1; ++x) {
          const float other = frame.depth[std::size_t{y} * camera.width + x];
          if (other > 0.0F) least = std::min(least, other);
        }
      }
      nearest[pixel] = least;
    }
  }
  return nearest;
}

std::vector<View> make_views(std::span<const SensorFrame> frames, const CameraIntrinsics& camera) {
  std::vector<View> views(frames.size());
  parallel_for_each(frames.size(), [&](std::size_t i) {
    views[i] = {frames[i].T_world_camera.inverse(), frames[i].T_world_camera.translation(),
                &frames[i].depth, nearest_of_neighbors(frames[i], camera)};
  });
  return views;
}

/// The number of frames that look through a voxel, and of those that measure a point in it.
struct Votes {
  int free = 0;
  int hits = 0;
};

class Voter {
 public:
  Voter(const std::vector<View>& views, const CameraIntrinsics& camera,
        const OccupancyFusionOptions& options)
      : views_(views), camera_(camera), options_(options) {}

  VoxelState state(const Eigen::Vector3d& center) const {
    Votes votes;
    for (const View& view : views_) vote(view, center, votes);
    if (votes.hits >= options_.min_hit_frames && 2 * votes.hits >= votes.free) {
      return VoxelState::occupied;
    }
    return votes.free >= options_.min_free_frames ? VoxelState::free : VoxelState::never_seen;
  }

 private:
  void vote(const View& view, const Eigen::Vector3d& center, Votes& votes) const {
    const Eigen::Vector3d p = view.T_camera_world * center;
    if (p.z() <= 0.0) return;
    const Eigen::Vector2d at = camera_.project(p);
    if (!(at.x() >= 1.0 && at.y() >= 1.0 && at.x() < camera_.width - 2.0 &&
          at.y() < camera_.height - 2.0)) {
      return;
    }
    const std::size_t pixel = static_cast<std::size_t>(at.y() + 0.5) * camera_.width +
                              static_cast<std::size_t>(at.x() + 0.5);
    const double measured = (*view.measured)[pixel];
    if (measured <= 0.0) return;
    if (p.z() < view.nearest[pixel] - options_.free_margin) {
      ++votes.free;
    } else if (std::abs(measured - p.z()) < options_.resolution &&
               hits(view, center, measured / p.z())) {
      ++votes.hits;
    }
  }

  /// Whether the measured point on the ray through the centre lies in the voxel.
  bool hits(const View& view, const Eigen::Vector3d& center, double stretch) const {
    const Eigen::Vector3d offset = (center - view.position) * (stretch - 1.0);
    return offset.cwiseAbs().maxCoeff() <= 0.5 * options_.resolution;
  }

  const std::vector<View>& views_;
  const CameraIntrinsics& camera_;
  const OccupancyFusionOptions& options_;
};

VoxelBlock covering_block(const OrientedBox& region, double resolution) {
  const Box bounds = world_bounds(region);
  const auto cell = [&](float x) { return static_cast<int>(std::floor(x / resolution)); };
  VoxelBlock block;
  for (int axis = 0; axis < 3; ++axis) {
    block.low[axis] = cell(bounds.min[axis]);
    block.size[axis] = cell(bounds.max[axis]) + 1 - block.low[axis];
    const int end = block.low[axis] + block.size[axis];
    if (block.low[axis] < -OccupancyMap::key_of_origin || end > OccupancyMap::key_of_origin) {
      throw InputError(
          "region", "a box within OctoMap's 65536 voxels",
          std::to_string(bounds.min[axis]) + " to " + std::to_string(bounds.max[axis]) + " m");
    }
  }
  block.states.assign(static_cast<std::size_t>(block.size.x()) *
                          static_cast<std::size_t>(block.size.y()) *
                          static_cast<std::size_t>(block.size.z()),
                      VoxelState::never_seen);
  return block;
}

}  // namespace

OccupancyMap fuse_occupancy(std::span<const SensorFrame> frames, const CameraIntrinsics& camera,
                            const OrientedBox& region, const OccupancyFusionOptions& options) {
  options.validate();
  const std::vector<View> views = make_views(frames, camera);
  const Voter voter(views, camera, options);
  const Eigen::Isometry3d T_box_world = region.T_world_box.inverse();
  VoxelBlock block = covering_block(region, options.resolution);
  const auto rows =
      static_cast<std::size_t>(block.size.y()) * static_cast<std::size_t>(block.size.z());
  const auto columns = static_cast<std::size_t>(block.size.x());
  parallel_for_blocks(rows, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row) % block.size.y();
      const int z = static_cast<int>(row) / block.size.y();
      for (int x = 0; x < block.size.x(); ++x) {
        const Eigen::Vector3i key = block.low + Eigen::Vector3i(x, y, z);
        const Eigen::Vector3d center = options.resolution * (key.cast<double>().array() + 0.5);
        const Eigen::Vector3d inside = T_box_world * center;
        if ((inside.array() < region.min.array()).any() ||
            (inside.array() > region.max.array()).any()) {
          continue;
        }
        block.states[row * columns + static_cast<std::size_t>(x)] = voter.state(center);
      }
    }
  });
  return to_octree(block, options.resolution);
}

}  // namespace symscene
