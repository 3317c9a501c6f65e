#include "reconstruction/measurement.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "depth_level.hpp"
#include "edge_surface.hpp"
#include "planar_normals.hpp"
#include "surface_normals.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::size_t max_levels = 3;
constexpr Index min_side = 8;  // of a level [px]

/// Packs the rows of Measurement::packed.
class RowPacker {
 public:
  /// Pixel (u, v) of `raw` lies in pixel (u >> shift, v >> shift) of `surface`.
  RowPacker(const DepthLevel& raw, const SurfaceImage& surface, std::size_t shift,
            const MeasurementOptions& options)
      : raw_(raw),
        surface_(surface),
        edges_(surface, options),
        shift_(shift),
        step_(static_cast<float>(options.edge_step)),
        min_cosine_(static_cast<float>(options.min_cosine)),
        ray_x_(raw.camera.column_rays()),
        ray_y_(raw.camera.row_rays()) {}

  void pack_row(std::size_t v, std::uint32_t* packed) const {
    const std::size_t width = raw_.camera.width;
    const float* const depth = raw_.depth.data() + v * width;
    const std::size_t row = std::min<std::size_t>(v >> shift_, surface_.camera.height - 1);
    const SurfacePixel* const surface = surface_.pixels.data() + row * surface_.camera.width;
    for (std::size_t u = 0; u < width; ++u) {
      const std::size_t at = u >> shift_;
      const bool measured = depth[u] > 0.0F && at < surface_.camera.width;
      if (!measured) {
        packed[u] = 0;
      } else if (surface[at].shows_surface()) {
        packed[u] = pack(depth[u], surface[at], ray_x_[u], ray_y_[v]);
      } else {
        const SurfacePixel edge = edges_.at(depth[u], {ray_x_[u], ray_y_[v], 1.0F}, at, row);
        packed[u] = pack(depth[u], edge, ray_x_[u], ray_y_[v]);
      }
    }
  }

 private:
  /// 0 where the pixel shows another surface than `pixel` or is seen at too flat an angle.
  std::uint32_t pack(float z, const SurfacePixel& pixel, float ray_x, float ray_y) const {
    const float cosine = -(pixel.nx * ray_x + pixel.ny * ray_y + pixel.nz);
    if (!(cosine > min_cosine_) || std::abs(pixel.depth - z) > step_ * z * z) return 0;
    const float ray_length = std::sqrt(1.0F + ray_x * ray_x + ray_y * ray_y);
    const auto tenths = static_cast<std::uint32_t>(z / Measurement::depth_unit + 0.5F);
    const auto factor = static_cast<std::uint32_t>(255.0F * std::min(cosine, 1.0F) + 0.5F);
    return (tenths << 16) | (factor << 8) | packed_weight_root(z, cosine / ray_length);
  }

  const DepthLevel& raw_;
  const SurfaceImage& surface_;
  EdgeSurface edges_;
  std::size_t shift_;
  float step_;        ///< at 1 m [m]
  float min_cosine_;  ///< of normal and ray
  std::vector<float> ray_x_, ray_y_;
};

std::vector<std::uint32_t> pack(const DepthLevel& raw, const SurfaceImage& surface,
                                std::size_t shift, const MeasurementOptions& options) {
  std::vector<std::uint32_t> packed(raw.depth.size() + 1);
  const RowPacker packer(raw, surface, shift, options);
  parallel_for_blocks(raw.camera.height, image_rows_per_task,
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t v = begin; v < end; ++v) {
                          packer.pack_row(v, packed.data() + v * raw.camera.width);
                        }
                      });
  return packed;
}

std::vector<SurfaceImage> surface_pyramid(DepthLevel level, const MeasurementOptions& options) {
  const auto step = static_cast<float>(options.edge_step);
  std::vector<SurfaceImage> pyramid;
  level = smooth(bridge_holes(level, step), smoothing_noise(options));
  pyramid.push_back(with_normals(level, normal_reach, step));
  while (pyramid.size() < max_levels && level.camera.width >= min_side &&
         level.camera.height >= min_side) {
    // Not smoothed again: the halves of a smooth image are smooth.
    level = halve(level, step);
    pyramid.push_back(with_normals(level, 1, step));
  }
  for (SurfaceImage& image : pyramid)
    smooth_planar_normals(image, options.noise, options.planar_normals);
  return pyramid;
}

std::size_t count_surface(const SurfaceImage& image) {
  return static_cast<std::size_t>(
      std::count_if(image.pixels.begin(), image.pixels.end(),
                    [](const SurfacePixel& pixel) { return pixel.shows_surface(); }));
}

void require_camera(const CameraIntrinsics& camera, const DepthFrame& frame) {
  if (camera.width < min_side || camera.height < min_side || !(camera.fx >= 1.0) ||
      !(camera.fy >= 1.0) || !std::isfinite(camera.fx + camera.fy + camera.cx + camera.cy)) {
    throw InputError("camera", "at least 8×8 pixels and focal lengths of a pixel or more",
                     std::to_string(camera.width) + "×" + std::to_string(camera.height));
  }
  if (frame.depth.size() != camera.pixels()) {
    throw InputError("depth image", std::to_string(camera.pixels()) + " pixels",
                     std::to_string(frame.depth.size()));
  }
}

}  // namespace

Measurement prepare_measurement(const DepthFrame& frame, const CameraIntrinsics& camera,
                                const MeasurementOptions& options) {
  options.validate();
  require_camera(camera, frame);
  const DepthLevel raw = keep_in_range(frame.depth, camera, options.min_depth, options.max_depth);
  DepthLevel level = raw;
  std::size_t shift = 0;
  while (level.camera.width >= 1.5 * options.tracking_width &&
         level.camera.height >= 2 * min_side) {
    level = halve(level, static_cast<float>(options.edge_step));
    ++shift;
  }
  Measurement measurement;
  measurement.camera = camera;
  if (frame.colors.rows() == static_cast<Eigen::Index>(camera.pixels())) {
    measurement.colors = &frame.colors;
  }
  measurement.pyramid = surface_pyramid(std::move(level), options);
  measurement.measured = count_surface(measurement.pyramid.front());
  measurement.packed = pack(raw, measurement.pyramid.front(), shift, options);
  return measurement;
}

}  // namespace symscene
