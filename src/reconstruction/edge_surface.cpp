#include "edge_surface.hpp"

#include <array>
#include <cmath>

namespace symscene {
namespace {

constexpr float deviations = 2.0F;  ///< up to which a depth lies on a plane

/// To the nearest pixels and those as far away as normals reach. [px]
constexpr std::array<std::array<int, 2>, 12> around = {{{0, -1},
                                                        {-1, 0},
                                                        {1, 0},
                                                        {0, 1},
                                                        {0, -2},
                                                        {-2, 0},
                                                        {2, 0},
                                                        {0, 2},
                                                        {-2, -2},
                                                        {2, -2},
                                                        {-2, 2},
                                                        {2, 2}}};

}  // namespace

SurfacePixel EdgeSurface::at(float z, const Eigen::Vector3f& ray, std::size_t column,
                             std::size_t row) const {
  const float deviation = noise_ * z * z;
  SurfacePixel best;
  if (deviation > max_deviation_) return best;
  float least = deviations * deviation;
  for (const auto& [right, down] : around) {
    const std::size_t u = column + static_cast<std::size_t>(right);  // wraps below 0
    const std::size_t v = row + static_cast<std::size_t>(down);
    if (u >= surface_.camera.width || v >= surface_.camera.height) continue;
    const SurfacePixel& pixel = surface_.pixels[v * surface_.camera.width + u];
    if (!pixel.shows_surface()) continue;
    const Eigen::Vector3f normal(pixel.nx, pixel.ny, pixel.nz);
    const Eigen::Vector3f point = pixel.depth * Eigen::Vector3f(ray_x_[u], ray_y_[v], 1.0F);
    const float residual = std::abs(normal.dot(point) / normal.dot(ray) - z);
    if (!(residual < least)) continue;
    least = residual;
    best = pixel;
  }
  best.depth = z;
  return best;
}

}  // namespace symscene
