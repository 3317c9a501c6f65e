#include "symscene/reconstruction/measurement.hpp"

#include <algorithm>
#include <cmath>

#include "core/dispatch.hpp"
#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::size_t rows_a_task = 16;

/// A depth image of one level.
struct DepthLevel {
  CameraIntrinsics camera;
  std::vector<float> depth;
};

/// What the sensor cannot have measured becomes 0.
SYMSCENE_MULTIVERSION
void keep_in_range(const float* depth, std::size_t count, float min, float max, float* kept) {
  for (std::size_t i = 0; i < count; ++i) {
    kept[i] = depth[i] >= min && depth[i] <= max ? depth[i] : 0.0F;
  }
}

CameraIntrinsics halved(const CameraIntrinsics& camera) {
  return {camera.width / 2, camera.height / 2,      0.5 * camera.fx,
          0.5 * camera.fy,  0.5 * camera.cx - 0.25, 0.5 * camera.cy - 0.25};
}

/// The mean of those of 2×2 pixels that show the same surface as the nearest of them, at least two.
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

DepthLevel halve(const DepthLevel& fine, float step) {
  DepthLevel coarse{halved(fine.camera), {}};
  const std::size_t width = coarse.camera.width;
  coarse.depth.resize(coarse.camera.pixels());
  parallel_for_blocks(coarse.camera.height, rows_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const float* upper = fine.depth.data() + 2 * v * fine.camera.width;
      halve_row(upper, upper + fine.camera.width, width, step, coarse.depth.data() + v * width);
    }
  });
  return coarse;
}

constexpr std::size_t smoothing_radius = 2;  // [px]
constexpr float smoothing_sigmas = 4.0F;
constexpr std::size_t normal_reach = 2;  // [px]

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

DepthLevel smooth(const DepthLevel& raw, float noise) {
  DepthLevel smoothed = raw;
  const std::size_t width = raw.camera.width, height = raw.camera.height;
  if (height <= 2 * smoothing_radius || width <= 2 * smoothing_radius) return smoothed;
  const std::size_t rows = height - 2 * smoothing_radius;
  parallel_for_blocks(rows, rows_a_task, [&](std::size_t begin, std::size_t end) {
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

/// Normals of one row from the differences of the points `reach` pixels to each side; none where
/// these lie on another surface. `ray_x` is the x of each column's ray.
SYMSCENE_MULTIVERSION
void normal_row(const float* above, const float* here, const float* below, const float* ray_x,
                float ray_y_above, float ray_y, float ray_y_below, std::size_t width,
                std::size_t reach, float step, SurfacePixel* out) {
  for (std::size_t u = reach; u + reach < width; ++u) {
    const float z = here[u], left = here[u - reach], right = here[u + reach];
    const float top = above[u], bottom = below[u];
    const float bound = step * z * (z > 1.0F ? z : 1.0F);
    const float least = std::min(std::min(left, right), std::min(top, bottom));
    const float spread_h = std::abs(left + right - 2.0F * z);
    const float spread_v = std::abs(top + bottom - 2.0F * z);
    const bool smooth = z > 0.0F && least > 0.0F && spread_h <= bound && spread_v <= bound;
    const float ax = right * ray_x[u + reach] - left * ray_x[u - reach];
    const float ay = (right - left) * ray_y;
    const float az = right - left;
    const float bx = (bottom - top) * ray_x[u];
    const float by = bottom * ray_y_below - top * ray_y_above;
    const float bz = bottom - top;
    // Down × right points to the camera.
    const float nx = by * az - bz * ay;
    const float ny = bz * ax - bx * az;
    const float nz = bx * ay - by * ax;
    const float squared = nx * nx + ny * ny + nz * nz;
    const float scale = smooth && squared > 0.0F ? 1.0F / std::sqrt(squared) : 0.0F;
    out[u].depth = z;
    out[u].nx = nx * scale;
    out[u].ny = ny * scale;
    out[u].nz = nz * scale;
  }
}

SurfaceImage with_normals(const DepthLevel& level, std::size_t reach, float step) {
  SurfaceImage image{level.camera, std::vector<SurfacePixel>(level.camera.pixels())};
  const std::size_t width = level.camera.width, height = level.camera.height;
  for (std::size_t i = 0; i < level.depth.size(); ++i) image.pixels[i].depth = level.depth[i];
  if (width <= 2 * reach || height <= 2 * reach) return image;
  const std::vector<float> ray_x = level.camera.column_rays();
  const std::vector<float> ray_y = level.camera.row_rays();
  parallel_for_blocks(height - 2 * reach, rows_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin + reach; v < end + reach; ++v) {
      const float* here = level.depth.data() + v * width;
      normal_row(here - reach * width, here, here + reach * width, ray_x.data(), ray_y[v - reach],
                 ray_y[v], ray_y[v + reach], width, reach, step, image.pixels.data() + v * width);
    }
  });
  return image;
}

/// One row of Measurement::packed; a pixel's surface is that of the pixel 2^shift times as large in
/// `surface`, unless its depth is `step` off at 1 m.
void pack_row(const float* depth, std::size_t width, const SurfacePixel* surface,
              std::size_t surface_width, std::size_t shift, const float* ray_x, float ray_y,
              float step, std::uint32_t* packed) {
  for (std::size_t u = 0; u < width; ++u) {
    packed[u] = 0;
    const float z = depth[u];
    const std::size_t at = u >> shift;
    if (!(z > 0.0F) || at >= surface_width) continue;
    const SurfacePixel& pixel = surface[at];
    const float cosine = -(pixel.nx * ray_x[u] + pixel.ny * ray_y + pixel.nz);
    if (!(cosine > 0.1F) || std::abs(pixel.depth - z) > step * z * z) continue;
    const float ray_length = std::sqrt(1.0F + ray_x[u] * ray_x[u] + ray_y * ray_y);
    const float incidence = cosine / ray_length;
    const float weight = 16.0F * incidence * incidence / (z * z * z * z);
    const auto tenths = static_cast<std::uint32_t>(z / Measurement::depth_unit + 0.5F);
    const auto factor = static_cast<std::uint32_t>(255.0F * std::min(cosine, 1.0F) + 0.5F);
    const auto units = static_cast<std::uint32_t>(std::clamp(weight, 1.0F, 255.0F));
    packed[u] = (tenths << 16) | (factor << 8) | units;
  }
}

std::vector<std::uint32_t> pack(const DepthLevel& raw, const SurfaceImage& surface,
                                std::size_t shift, float step) {
  std::vector<std::uint32_t> packed(raw.depth.size() + 1);
  const std::size_t width = raw.camera.width;
  const std::vector<float> ray_x = raw.camera.column_rays();
  const std::vector<float> ray_y = raw.camera.row_rays();
  parallel_for_blocks(raw.camera.height, rows_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const std::size_t row = std::min<std::size_t>(v >> shift, surface.camera.height - 1);
      pack_row(raw.depth.data() + v * width, width,
               surface.pixels.data() + row * surface.camera.width, surface.camera.width, shift,
               ray_x.data(), ray_y[v], step, packed.data() + v * width);
    }
  });
  return packed;
}

std::size_t count_surface(const SurfaceImage& image) {
  return static_cast<std::size_t>(
      std::count_if(image.pixels.begin(), image.pixels.end(),
                    [](const SurfacePixel& pixel) { return pixel.shows_surface(); }));
}

void require_camera(const CameraIntrinsics& camera, const DepthFrame& frame) {
  if (camera.width < 8 || camera.height < 8 || !(camera.fx >= 1.0) || !(camera.fy >= 1.0) ||
      !std::isfinite(camera.fx + camera.fy + camera.cx + camera.cy)) {
    throw InputError("camera", "at least 8×8 pixels and focal lengths of a pixel or more",
                     std::to_string(camera.width) + "×" + std::to_string(camera.height));
  }
  if (frame.depth.size() != camera.pixels()) {
    throw InputError("depth image", std::to_string(camera.pixels()) + " pixels",
                     std::to_string(frame.depth.size()));
  }
}

}  // namespace

void MeasurementOptions::validate() const {
  require_option(min_depth > 0, "min_depth", "a positive number", min_depth);
  require_option(max_depth > min_depth && max_depth < 6.5, "max_depth",
                 "more than min_depth and below 6.5 m", max_depth);
  require_option(noise >= 1e-6 && noise <= 1, "noise", "1e-6 to 1 / m", noise);
  require_option(edge_step > 0 && edge_step <= 1, "edge_step", "a positive number up to 1 m",
                 edge_step);
  require_option(tracking_width >= 40, "tracking_width", "at least 40 px", tracking_width);
}

SurfaceImage find_surface(std::vector<float> depth, const CameraIntrinsics& camera,
                          const MeasurementOptions& options) {
  const DepthLevel level =
      smooth({camera, std::move(depth)}, smoothing_sigmas * static_cast<float>(options.noise));
  return with_normals(level, normal_reach, static_cast<float>(options.edge_step));
}

Measurement prepare_measurement(const DepthFrame& frame, const CameraIntrinsics& camera,
                                const MeasurementOptions& options) {
  options.validate();
  require_camera(camera, frame);
  const auto step = static_cast<float>(options.edge_step);
  DepthLevel raw{camera, std::vector<float>(camera.pixels())};
  keep_in_range(frame.depth.data(), raw.depth.size(), static_cast<float>(options.min_depth),
                static_cast<float>(options.max_depth), raw.depth.data());
  Measurement measurement;
  measurement.camera = camera;
  if (frame.colors.rows() == static_cast<Eigen::Index>(camera.pixels())) {
    measurement.colors = &frame.colors;
  }
  DepthLevel level = raw;
  std::size_t shift = 0;
  while (level.camera.width >= 1.5 * options.tracking_width && level.camera.height >= 16) {
    level = halve(level, step);
    ++shift;
  }
  for (std::size_t depth = 0; depth < 3 && level.camera.width >= 8 && level.camera.height >= 8;
       ++depth) {
    if (depth > 0) level = halve(level, step);
    // Smoothed once: what is halved from it is smooth.
    if (depth == 0) level = smooth(level, smoothing_sigmas * static_cast<float>(options.noise));
    measurement.pyramid.push_back(with_normals(level, depth == 0 ? normal_reach : 1, step));
  }
  measurement.measured = count_surface(measurement.pyramid.front());
  measurement.packed =
      pack(raw, measurement.pyramid.front(), shift, static_cast<float>(options.edge_step));
  return measurement;
}

}  // namespace symscene
