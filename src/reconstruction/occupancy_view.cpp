#include "reconstruction/occupancy_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "symscene/core/dispatch.hpp"
#include "symscene/core/parallel.hpp"

namespace symscene {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr std::size_t rows_a_task = 32;

/// The least measured depth of each pixel and its two neighbours in the row; infinity if none.
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

/// The limit of the pixels of a row from the least depths of three rows.
SYMSCENE_MULTIVERSION
void limit_row(const float* above, const float* here, const float* below, std::size_t width,
               float margin, float max_depth, float* limit) {
  for (std::size_t u = 1; u + 1 < width; ++u) {
    const float sides = above[u] < below[u] ? above[u] : below[u];
    const float least = sides < here[u] ? sides : here[u];
    const float free = least - margin;
    const float within = free < max_depth ? free : max_depth;
    limit[u] = least < infinite && within > 0.0F ? within : 0.0F;
  }
}

/// Zero at the image's border: a voxel that falls on no pixel can be looked up there.
std::vector<float> depth_limits(const DepthFrame& frame, const CameraIntrinsics& camera,
                                const OccupancyVolumeOptions& options) {
  const std::size_t width = camera.width;
  const std::size_t height = camera.height;
  std::vector<float> least(camera.pixels(), infinite);
  parallel_for_blocks(height, rows_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      least_in_row(frame.depth.data() + v * width, width, least.data() + v * width);
    }
  });
  std::vector<float> limits(camera.pixels(), 0.0F);
  parallel_for_blocks(height, rows_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = std::max<std::size_t>(begin, 1); v < std::min(end, height - 1); ++v) {
      const float* const row = least.data() + v * width;
      limit_row(row - width, row, row + width, width, static_cast<float>(options.free_margin),
                static_cast<float>(options.max_depth), limits.data() + v * width);
    }
  });
  return limits;
}

/// What the voxel loop reads, as plain arrays and numbers.
struct VoxelLoop {
  const float* x;
  const float* y;
  const float* z;
  float first_x, first_y, first_z;
  float cx, cy;  ///< half a pixel more, so that cutting off rounds
  float max_u, max_v;
  const float* limits;
  int width;
};

/// In three loops over arrays that nothing else points to: so compilers see that they vectorise.
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

Sight OccupancyView::look_at(const Eigen::Vector3f& first, int level) const {
  // Voxels and corners round differently.
  constexpr float depth_slack = 1e-5F;  // [m]
  constexpr float pixel_slack = 0.02F;
  const Offsets<8>& corners = corners_[static_cast<std::size_t>(level)];
  const float first_x = first.x() * fx_;
  const float first_y = first.y() * fy_;
  float low_z = infinite, high_z = -infinite;
  for (std::size_t k = 0; k < 8; ++k) {
    const float z = first.z() + corners.z[k];
    low_z = std::min(low_z, z);
    high_z = std::max(high_z, z);
  }
  low_z -= depth_slack;
  high_z += depth_slack;
  if (high_z <= 0.0F || low_z >= limits_.max()) return Sight::none;
  constexpr float least_z = 1e-3F;
  if (low_z < least_z) return Sight::some;

  float low_u = infinite, high_u = -infinite, low_v = infinite, high_v = -infinite;
  for (std::size_t k = 0; k < 8; ++k) {
    const float inverse = 1.0F / (first.z() + corners.z[k]);
    const float u = (first_x + corners.x[k]) * inverse;
    const float v = (first_y + corners.y[k]) * inverse;
    low_u = std::min(low_u, u);
    high_u = std::max(high_u, u);
    low_v = std::min(low_v, v);
    high_v = std::max(high_v, v);
  }
  low_u += cx_ - pixel_slack;
  high_u += cx_ + pixel_slack;
  low_v += cy_ - pixel_slack;
  high_v += cy_ + pixel_slack;
  const auto last_u = static_cast<float>(limits_.width() - 1);
  const auto last_v = static_cast<float>(limits_.height() - 1);
  if (high_u < 1.0F || high_v < 1.0F || low_u >= last_u || low_v >= last_v) return Sight::none;

  const bool inside = low_u >= 1.0F && low_v >= 1.0F && high_u < last_u && high_v < last_v;
  const RangePyramid::Range limit = limits_.bounds(
      {static_cast<int>(std::max(low_u, 1.0F)), static_cast<int>(std::max(low_v, 1.0F)),
       static_cast<int>(std::min(high_u, last_u)), static_cast<int>(std::min(high_v, last_v))});
  if (low_z >= limit.max) return Sight::none;
  return inside && high_z < limit.min ? Sight::all : Sight::some;
}

void OccupancyView::look_through(const Eigen::Vector3f& first, std::uint8_t* looks) const {
  look_through_voxels(
      {voxels_.x.data(), voxels_.y.data(), voxels_.z.data(), first.x() * fx_, first.y() * fy_,
       first.z(), cx_, cy_, static_cast<float>(limits_.width() - 1),
       static_cast<float>(limits_.height() - 1), limits_.values(), limits_.width()},
      looks);
}

}  // namespace symscene
