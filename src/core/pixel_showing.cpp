#include "core/pixel_showing.hpp"

#include <cmath>
#include <limits>

namespace symscene {
namespace {

constexpr int max_radius = 8;  // [px], of a hole

/// The measured pixel of the depth nearest to z, in a square around a pixel.
std::optional<std::size_t> most_similar(const Eigen::Vector2i& middle, int radius, double z,
                                        std::span<const float> depth,
                                        const CameraIntrinsics& camera) {
  const Eigen::Vector2i last(camera.width - 1, camera.height - 1);
  const Eigen::Vector2i from = (middle.array() - radius).max(0);
  const Eigen::Vector2i to = (middle.array() + radius).matrix().cwiseMin(last);
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (int v = from.y(); v <= to.y(); ++v) {
    for (int u = from.x(); u <= to.x(); ++u) {
      const std::size_t pixel =
          static_cast<std::size_t>(v) * camera.width + static_cast<std::size_t>(u);
      const double difference = std::abs(double{depth[pixel]} - z);
      if (!(depth[pixel] > 0.0F) || difference >= least) continue;
      least = difference;
      best = pixel;
    }
  }
  return best;
}

}  // namespace

std::optional<Eigen::Vector2i> projected_pixel(const Eigen::Vector3d& point_camera,
                                               const CameraIntrinsics& camera) {
  if (!(point_camera.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d pixel = camera.project(point_camera).array().round();
  if (!(pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < camera.width &&
        pixel.y() < camera.height))
    return std::nullopt;
  return pixel.cast<int>();
}

std::optional<std::size_t> pixel_showing(const Eigen::Vector3d& point_camera,
                                         std::span<const float> depth,
                                         const CameraIntrinsics& camera) {
  const std::optional<Eigen::Vector2i> middle = projected_pixel(point_camera, camera);
  std::optional<std::size_t> pixel;
  for (int radius = 0; middle && !pixel && radius <= max_radius; ++radius)
    pixel = most_similar(*middle, radius, point_camera.z(), depth, camera);
  return pixel;
}

}  // namespace symscene
