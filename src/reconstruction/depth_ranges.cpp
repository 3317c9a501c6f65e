#include "depth_ranges.hpp"

#include <algorithm>
#include <limits>

namespace symscene {
namespace {

constexpr Index tile_width = DepthRanges::tile;
constexpr float closest = 0.02F;  // depth from which surface is shown [m]

/// The interval of pixels that a box covers along one axis of the image.
struct PixelSpan {
  float first, last;
};

/// The box of a block in the camera's axes, between two depths. [m]
struct BlockBox {
  Eigen::Vector3f center;
  Eigen::Vector3f reach;
  float nearest, farthest;

  PixelSpan project(int axis, float focal, float principal) const {
    const float inverse_near = 1.0F / nearest, inverse_far = 1.0F / farthest;
    const float low = center[axis] - reach[axis], high = center[axis] + reach[axis];
    return {std::min(low * inverse_near, low * inverse_far) * focal + principal,
            std::max(high * inverse_near, high * inverse_far) * focal + principal};
  }
};

/// The first and last tile of an interval of pixels.
struct TileSpan {
  Index first, last;

  TileSpan(const PixelSpan& pixels, float last_pixel)
      : first(tile_at(pixels.first, last_pixel)), last(tile_at(pixels.last + 1.0F, last_pixel)) {}

 private:
  static Index tile_at(float pixel, float last_pixel) {
    return static_cast<Index>(std::clamp(pixel, 0.0F, last_pixel)) / tile_width;
  }
};

/// Widens the ranges of the tiles that a box may cover.
void cover(const BlockBox& box, const CameraIntrinsics& camera, DepthRanges& ranges) {
  const PixelSpan u = box.project(0, static_cast<float>(camera.fx), static_cast<float>(camera.cx));
  const PixelSpan v = box.project(1, static_cast<float>(camera.fy), static_cast<float>(camera.cy));
  const auto right = static_cast<float>(camera.width - 1);
  const auto bottom = static_cast<float>(camera.height - 1);
  if (u.last < 0 || v.last < 0 || u.first > right || v.first > bottom) return;
  const TileSpan columns(u, right), rows(v, bottom);
  for (Index y = rows.first; y <= rows.last; ++y) {
    for (Index x = columns.first; x <= columns.last; ++x) {
      const std::size_t at = std::size_t{y} * ranges.columns + x;
      ranges.nearest[at] = std::min(ranges.nearest[at], box.nearest);
      ranges.farthest[at] = std::max(ranges.farthest[at], box.farthest);
    }
  }
}

}  // namespace

DepthRanges find_depth_ranges(const TsdfVolume& volume, const CameraIntrinsics& camera,
                              const Eigen::Isometry3d& T_camera_world) {
  DepthRanges ranges;
  ranges.columns = (camera.width + tile_width - 1) / tile_width;
  const Index rows = (camera.height + tile_width - 1) / tile_width;
  ranges.nearest.assign(std::size_t{ranges.columns} * rows, std::numeric_limits<float>::infinity());
  ranges.farthest.assign(ranges.nearest.size(), 0.0F);
  const double block_size = volume.voxel_size() * TsdfBlock::edge;
  // One voxel more than the block, as its outermost cells reach into the next block.
  const Eigen::Vector3f reach = (T_camera_world.linear().cwiseAbs() *
                                 Eigen::Vector3d::Constant(0.5 * block_size + volume.voxel_size()))
                                    .cast<float>();
  const Eigen::Matrix3f R = (T_camera_world.linear() * block_size).cast<float>();
  const Eigen::Vector3f t =
      (T_camera_world * Eigen::Vector3d::Constant(0.5 * block_size)).cast<float>();
  for (std::size_t slot = 0; slot < volume.index().size(); ++slot) {
    if (!volume.near_surface(slot)) continue;
    const Eigen::Vector3f center = R * volume.index().blocks()[slot].cast<float>() + t;
    const float farthest = center.z() + reach.z();
    if (!(farthest > closest)) continue;
    cover({center, reach, std::max(center.z() - reach.z(), closest), farthest}, camera, ranges);
  }
  return ranges;
}

}  // namespace symscene
