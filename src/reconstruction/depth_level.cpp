#include "depth_level.hpp"

#include <algorithm>
#include <cmath>

#include "core/dispatch.hpp"
#include "core/parallel.hpp"

namespace symscene {
namespace {

constexpr std::size_t smoothing_radius = 2;  // [px]

SYMSCENE_MULTIVERSION
void copy_in_range(const float* depth, std::size_t count, float min, float max, float* kept) {
  for (std::size_t i = 0; i < count; ++i) {
    kept[i] = depth[i] >= min && depth[i] <= max ? depth[i] : 0.0F;
  }
}

CameraIntrinsics halved(const CameraIntrinsics& camera) {
  return {camera.width / 2, camera.height / 2,      0.5 * camera.fx,
          0.5 * camera.fy,  0.5 * camera.cx - 0.25, 0.5 * camera.cy - 0.25};
}

SYMSCENE_MULTIVERSION
void halve_row(const float* upper, const float* lower, std::size_t width, float step, float* out) {
  for (std::size_t u = 0; u < width; ++u) {
    const float d[4] = {upper[2 * u], upper[2 * u + 1], lower[2 * u], lower[2 * u + 1]};
    float nearest = 1e9F;
    for (const float z : d) nearest = z > 0.0F && z < nearest ? z : nearest;
    const float bound = nearest * (1.0F + step);
    float sum = 0.0F, count = 0.0F;
    for (const float z : d) {
      const bool same = z > 0.0F && z <= bound;
      sum += same ? z : 0.0F;
      count += same ? 1.0F : 0.0F;
    }
    out[u] = count >= 2.0F ? sum / count : 0.0F;
  }
}

/// One row of a bilateral filter over 5×5 pixels: weights fall to zero at `noise` times the squared
/// depth. `rows` are the five rows about it. In strips of fixed width, which compilers vectorise.
SYMSCENE_MULTIVERSION
void smooth_row(const float* const* rows, std::size_t width, float noise, float* __restrict out) {
  constexpr std::size_t strip = 64;
  const std::size_t end = width - smoothing_radius;
  for (std::size_t left = smoothing_radius; left < end; left += strip) {
    // The last strip lies over the one before it; a narrow image has one short strip.
    const std::size_t first =
        left + strip > end && end >= strip + smoothing_radius ? end - strip : left;
    const std::size_t count = std::min(strip, end - first);
    float falloff[strip], sum[strip], total[strip];
    const float* const center = rows[smoothing_radius] + first;
    for (std::size_t i = 0; i < count; ++i) {
      const float reach = noise * center[i] * center[i];
      falloff[i] = center[i] > 0.0F ? 1.0F / (reach * reach) : 0.0F;
      sum[i] = total[i] = 0.0F;
    }
    for (std::size_t y = 0; y <= 2 * smoothing_radius; ++y) {
      for (std::size_t x = 0; x <= 2 * smoothing_radius; ++x) {
        const float* const z = rows[y] + first + x - smoothing_radius;
        for (std::size_t i = 0; i < count; ++i) {
          const float step = z[i] - center[i];
          const float weight = 1.0F - step * step * falloff[i];
          const float used = weight > 0.0F ? weight : 0.0F;
          sum[i] += used * z[i];
          total[i] += used;
        }
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      out[first + i] = center[i] > 0.0F ? sum[i] / total[i] : 0.0F;
    }
  }
}

/// The mean of two depths of one surface; 0 if they are not both measured and of one surface.
inline float between(float a, float b, float step) {
  const float mean = 0.5F * (a + b);
  const float bound = step * mean * (mean > 1.0F ? mean : 1.0F);
  return std::min(a, b) > 0.0F && std::abs(a - b) <= bound ? mean : 0.0F;
}

/// Fills the holes of one row between neighbours on opposite sides, or opposite corners.
SYMSCENE_MULTIVERSION
void bridge_row(const float* here, std::size_t width, float step, float* __restrict out) {
  const float* const above = here - width;
  const float* const below = here + width;
  for (std::size_t u = 1; u + 1 < width; ++u) {
    const float across = between(here[u - 1], here[u + 1], step);
    const float down = between(above[u], below[u], step);
    const float falling = between(above[u - 1], below[u + 1], step);
    const float rising = between(below[u - 1], above[u + 1], step);
    const float diagonal = falling > 0.0F ? falling : rising;
    const float side = across > 0.0F ? across : down;
    const float filled = side > 0.0F ? side : diagonal;
    out[u] = here[u] > 0.0F ? here[u] : filled;
  }
}

}  // namespace

DepthLevel keep_in_range(const std::vector<float>& depth, const CameraIntrinsics& camera,
                         double min, double max) {
  DepthLevel kept{camera, std::vector<float>(camera.pixels())};
  copy_in_range(depth.data(), kept.depth.size(), static_cast<float>(min), static_cast<float>(max),
                kept.depth.data());
  return kept;
}

DepthLevel halve(const DepthLevel& fine, float step) {
  DepthLevel coarse{halved(fine.camera), {}};
  const std::size_t width = coarse.camera.width;
  coarse.depth.resize(coarse.camera.pixels());
  parallel_for_blocks(
      coarse.camera.height, image_rows_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          const float* upper = fine.depth.data() + 2 * v * fine.camera.width;
          halve_row(upper, upper + fine.camera.width, width, step, coarse.depth.data() + v * width);
        }
      });
  return coarse;
}

DepthLevel bridge_holes(const DepthLevel& raw, float step) {
  DepthLevel bridged = raw;
  const std::size_t width = raw.camera.width, height = raw.camera.height;
  if (height < 3) return bridged;
  parallel_for_blocks(height - 2, image_rows_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin + 1; v < end + 1; ++v) {
      const float* const here = raw.depth.data() + v * width;
      bridge_row(here, width, step, bridged.depth.data() + v * width);
    }
  });
  return bridged;
}

DepthLevel smooth(const DepthLevel& raw, float noise) {
  DepthLevel smoothed = raw;
  const std::size_t width = raw.camera.width, height = raw.camera.height;
  if (height <= 2 * smoothing_radius || width <= 2 * smoothing_radius) return smoothed;
  const std::size_t rows = height - 2 * smoothing_radius;
  parallel_for_blocks(rows, image_rows_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t top = begin; top < end; ++top) {
      const float* about[2 * smoothing_radius + 1];
      for (std::size_t y = 0; y <= 2 * smoothing_radius; ++y) {
        about[y] = raw.depth.data() + (top + y) * width;
      }
      smooth_row(about, width, noise, smoothed.depth.data() + (top + smoothing_radius) * width);
    }
  });
  return smoothed;
}

}  // namespace symscene
