#include "occupancy_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/dispatch.hpp"
#include "core/parallel.hpp"

namespace symscene {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr std::size_t limit_rows_per_task = 32;

/// The smallest measured depth of each pixel and its two neighbours in the row; infinity if none.
SYMSCENE_MULTIVERSION
void least_in_row(const float* depth, std::size_t width, float* least) {
  const auto measured = [](float d) { return d > 0.0F && d < infinite ? d : infinite; };
  for (std::size_t u = 1; u + 1 < width; ++u) {
    const float a = measured(depth[u - 1]);
    const float b = measured(depth[u]);
    const float c = measured(depth[u + 1]);
    const float sides = a < c ? a : c;
    least[u] = sides < b ? sides : b;
  }
}

struct LimitBounds {
  float margin, max_depth;  ///< [m]
};

/// The limits of the pixels of a row, from the smallest depths of it and of the rows beside it.
SYMSCENE_MULTIVERSION
void limit_row(const float* here, std::size_t width, LimitBounds bounds, float* limit) {
  const float* const above = here - width;
  const float* const below = here + width;
  for (std::size_t u = 1; u + 1 < width; ++u) {
    const float sides = above[u] < below[u] ? above[u] : below[u];
    const float least = sides < here[u] ? sides : here[u];
    const float free = least - bounds.margin;
    const float within = free < bounds.max_depth ? free : bounds.max_depth;
    limit[u] = least < infinite && within > 0.0F ? within : 0.0F;
  }
}

/// Up to which depth each pixel looks through. Zero at the image's border, which stands for voxels
/// outside the image.
std::vector<float> depth_limits(const DepthFrame& frame, const CameraIntrinsics& camera,
                                const OccupancyVolumeOptions& options) {
  const std::size_t width = camera.width;
  const std::size_t height = camera.height;
  std::vector<float> least(camera.pixels(), infinite);
  parallel_for_blocks(height, limit_rows_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      least_in_row(frame.depth.data() + v * width, width, least.data() + v * width);
    }
  });
  const LimitBounds bounds{static_cast<float>(options.free_margin),
                           static_cast<float>(options.max_depth)};
  std::vector<float> limits(camera.pixels(), 0.0F);
  parallel_for_blocks(height, limit_rows_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = std::max<std::size_t>(begin, 1); v < std::min(end, height - 1); ++v) {
      limit_row(least.data() + v * width, width, bounds, limits.data() + v * width);
    }
  });
  return limits;
}

/// The input of the voxel loop as plain arrays and numbers.
struct VoxelLoop {
  const float* x;
  const float* y;
  const float* z;
  float first_x, first_y, first_z;
  float cx, cy;  ///< plus half a pixel, so that truncation rounds
  float max_u, max_v;
  const float* limits;
  int width;
};

/// Three loops over local arrays, which compilers vectorise.
SYMSCENE_MULTIVERSION
void look_through_voxels(const VoxelLoop& loop, std::uint8_t* looks) {
  const VoxelLoop in = loop;
  std::array<float, block_voxels> depth;
  std::array<std::int32_t, block_voxels> pixel;
  for (std::size_t i = 0; i < block_voxels; ++i) {
    const float z = in.first_z + in.z[i];
    const float inverse = 1.0F / z;
    float u = (in.first_x + in.x[i]) * inverse + in.cx;
    float v = (in.first_y + in.y[i]) * inverse + in.cy;
    u = u > 0.0F ? u : 0.0F;
    v = v > 0.0F ? v : 0.0F;
    u = u < in.max_u ? u : in.max_u;
    v = v < in.max_v ? v : in.max_v;
    depth[i] = z;
    pixel[i] = static_cast<std::int32_t>(v) * in.width + static_cast<std::int32_t>(u);
  }
  std::array<std::int32_t, block_voxels> through;
  for (std::size_t i = 0; i < block_voxels; ++i) {
    const float limit = in.limits[pixel[i]];
    through[i] = depth[i] < limit ? 1 : 0;
  }
  for (std::size_t i = 0; i < block_voxels; ++i) {
    looks[i] = static_cast<std::uint8_t>(through[i] & (depth[i] > 0.0F ? 1 : 0));
  }
}

}  // namespace

template <std::size_t count>
void OccupancyView::fill_offsets(Offsets<count>& offsets, int spacing) const {
  for (std::size_t i = 0; i < count; ++i) {
    const OctreeKey key = octree_key(i);
    const Eigen::Vector3d step(key[0], key[1], key[2]);
    const Eigen::Vector3d offset = T_camera_world_.linear() * (spacing * resolution_ * step);
    offsets.x[i] = static_cast<float>(offset.x()) * fx_;
    offsets.y[i] = static_cast<float>(offset.y()) * fy_;
    offsets.z[i] = static_cast<float>(offset.z());
  }
}

OccupancyView::OccupancyView(const DepthFrame& frame, const CameraIntrinsics& camera,
                             const Eigen::Isometry3d& T_world_camera,
                             const OccupancyVolumeOptions& options)
    : T_camera_world_(T_world_camera.inverse()),
      resolution_(options.resolution),
      fx_(static_cast<float>(camera.fx)),
      fy_(static_cast<float>(camera.fy)),
      cx_(static_cast<float>(camera.cx + 0.5)),
      cy_(static_cast<float>(camera.cy + 0.5)),
      limits_(depth_limits(frame, camera, options), camera.width, camera.height) {
  fill_offsets(voxels_, 1);
  for (int level = block_level; level <= brick_level; ++level) {
    fill_offsets(corners_[static_cast<std::size_t>(level)], (1 << level) - 1);
  }
}

OccupancyView::Bounds OccupancyView::depths(const Eigen::Vector3f& first,
                                            const Offsets<8>& corners) {
  Bounds z{infinite, -infinite};
  for (const float offset : corners.z) {
    z.low = std::min(z.low, first.z() + offset);
    z.high = std::max(z.high, first.z() + offset);
  }
  constexpr float slack = 1e-5F;  // voxels and corners round differently [m]
  return {z.low - slack, z.high + slack};
}

OccupancyView::ImageBounds OccupancyView::project(const Eigen::Vector3f& first,
                                                  const Offsets<8>& corners) const {
  ImageBounds bounds{{infinite, -infinite}, {infinite, -infinite}};
  for (std::size_t k = 0; k < 8; ++k) {
    const float inverse = 1.0F / (first.z() + corners.z[k]);
    const float u = (first.x() * fx_ + corners.x[k]) * inverse;
    const float v = (first.y() * fy_ + corners.y[k]) * inverse;
    bounds.u = {std::min(bounds.u.low, u), std::max(bounds.u.high, u)};
    bounds.v = {std::min(bounds.v.low, v), std::max(bounds.v.high, v)};
  }
  constexpr float slack = 0.02F;  // [px]
  bounds.u = {bounds.u.low + cx_ - slack, bounds.u.high + cx_ + slack};
  bounds.v = {bounds.v.low + cy_ - slack, bounds.v.high + cy_ + slack};
  return bounds;
}

Sight OccupancyView::look_at(const Eigen::Vector3f& first, int level) const {
  const Offsets<8>& corners = corners_[static_cast<std::size_t>(level)];
  const Bounds z = depths(first, corners);
  if (z.high <= 0.0F || z.low >= limits_.max()) return Sight::none;
  constexpr float least_z = 1e-3F;
  if (z.low < least_z) return Sight::some;

  const auto [u, v] = project(first, corners);
  const auto last_u = static_cast<float>(limits_.width() - 1);
  const auto last_v = static_cast<float>(limits_.height() - 1);
  if (u.high < 1.0F || v.high < 1.0F || u.low >= last_u || v.low >= last_v) return Sight::none;

  const RangePyramid::Range limit = limits_.bounds(
      {static_cast<int>(std::max(u.low, 1.0F)), static_cast<int>(std::max(v.low, 1.0F)),
       static_cast<int>(std::min(u.high, last_u)), static_cast<int>(std::min(v.high, last_v))});
  if (z.low >= limit.max) return Sight::none;
  const bool inside = u.low >= 1.0F && v.low >= 1.0F && u.high < last_u && v.high < last_v;
  return inside && z.high < limit.min ? Sight::all : Sight::some;
}

void OccupancyView::look_through(const Eigen::Vector3f& first, std::uint8_t* looks) const {
  look_through_voxels(
      {voxels_.x.data(), voxels_.y.data(), voxels_.z.data(), first.x() * fx_, first.y() * fy_,
       first.z(), cx_, cy_, static_cast<float>(limits_.width() - 1),
       static_cast<float>(limits_.height() - 1), limits_.values(), limits_.width()},
      looks);
}

}  // namespace symscene
