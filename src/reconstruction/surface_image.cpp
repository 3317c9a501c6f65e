#include "reconstruction/surface_image.hpp"

#include <algorithm>
#include <cmath>

#include "core/dispatch.hpp"
#include "core/parallel.hpp"
#include "planar_normals.hpp"
#include "surface_normals.hpp"

namespace symscene {
namespace {

/// A row of depths between the rows `reach` above and below it.
struct NormalRow {
  const float* above;
  const float* here;
  const float* below;
  const float* ray_x;  ///< x of each column's ray
  float ray_y_above, ray_y, ray_y_below;
  std::size_t width;
  std::size_t reach;  ///< [px]
  float step;         ///< depth difference at 1 m that makes an edge [m]
};

/// Normals from the differences of the points `reach` pixels to each side; none where these lie on
/// another surface.
SYMSCENE_MULTIVERSION
void normal_row(const NormalRow& row, SurfacePixel* out) {
  const NormalRow in = row;
  const float *const above = in.above, *const here = in.here, *const below = in.below;
  const float* const ray_x = in.ray_x;
  const std::size_t reach = in.reach;
  for (std::size_t u = reach; u + reach < in.width; ++u) {
    const float z = here[u], left = here[u - reach], right = here[u + reach];
    const float top = above[u], bottom = below[u];
    const float bound = in.step * z * (z > 1.0F ? z : 1.0F);
    const float least = std::min(std::min(left, right), std::min(top, bottom));
    const float spread_h = std::abs(left + right - 2.0F * z);
    const float spread_v = std::abs(top + bottom - 2.0F * z);
    const bool smooth = z > 0.0F && least > 0.0F && spread_h <= bound && spread_v <= bound;
    const float ax = right * ray_x[u + reach] - left * ray_x[u - reach];
    const float ay = (right - left) * in.ray_y;
    const float az = right - left;
    const float bx = (bottom - top) * ray_x[u];
    const float by = bottom * in.ray_y_below - top * in.ray_y_above;
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

}  // namespace

SurfaceImage with_normals(const DepthLevel& level, std::size_t reach, float step) {
  SurfaceImage image{level.camera, std::vector<SurfacePixel>(level.camera.pixels())};
  const std::size_t width = level.camera.width, height = level.camera.height;
  for (std::size_t i = 0; i < level.depth.size(); ++i) image.pixels[i].depth = level.depth[i];
  if (width <= 2 * reach || height <= 2 * reach) return image;
  const std::vector<float> ray_x = level.camera.column_rays();
  const std::vector<float> ray_y = level.camera.row_rays();
  parallel_for_blocks(
      height - 2 * reach, image_rows_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin + reach; v < end + reach; ++v) {
          const float* here = level.depth.data() + v * width;
          normal_row({here - reach * width, here, here + reach * width, ray_x.data(),
                      ray_y[v - reach], ray_y[v], ray_y[v + reach], width, reach, step},
                     image.pixels.data() + v * width);
        }
      });
  return image;
}

SurfaceImage find_surface(std::vector<float> depth, const CameraIntrinsics& camera,
                          const MeasurementOptions& options) {
  const auto step = static_cast<float>(options.edge_step);
  const DepthLevel level =
      smooth(bridge_holes({camera, std::move(depth)}, step), smoothing_noise(options));
  SurfaceImage image = with_normals(level, normal_reach, step);
  smooth_planar_normals(image, options.noise, options.planar_normals);
  return image;
}

}  // namespace symscene
