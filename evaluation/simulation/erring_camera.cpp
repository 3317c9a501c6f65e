#include "simulation/erring_camera.hpp"

#include <limits>

#include "core/parallel.hpp"

namespace symscene {
namespace {

std::vector<Eigen::Vector2d> rays_of(const CameraIntrinsics& camera, const LensDistortion& lens) {
  if (lens.is_none()) return {};
  std::vector<Eigen::Vector2d> rays(camera.pixels());
  parallel_for_each(camera.height, [&](std::size_t v) {
    for (Index u = 0; u < camera.width; ++u) {
      const Eigen::Vector2d shown = camera.ray(u, static_cast<double>(v)).head<2>();
      rays[v * camera.width + u] = lens.undistorted(shown).value_or(
          Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()));
    }
  });
  return rays;
}

CameraErrorOptions checked(const CameraErrorOptions& options) {
  options.validate();
  return options;
}

}  // namespace

ErringCamera::ErringCamera(const CameraIntrinsics& camera, const CameraErrorOptions& options)
    : camera_(camera),
      options_(checked(options)),
      bias_(options, camera),
      rays_(rays_of(camera, options.lens())) {}

SensorFrame ErringCamera::render(const DepthRenderer& renderer,
                                 const Eigen::Isometry3d& T_world_camera) const {
  SensorFrame frame = renderer.render(camera_, T_world_camera, rays_);
  if (options_.depth_bias == 0.0) return frame;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    Eigen::Vector2d pixel(static_cast<double>(i % camera_.width),
                          static_cast<double>(i / camera_.width));
    if (!rays_.empty())
      pixel << camera_.fx * rays_[i].x() + camera_.cx, camera_.fy * rays_[i].y() + camera_.cy;
    const double z = frame.depth[i];
    if (z > 0.0) frame.depth[i] = static_cast<float>(z * bias_.factor(pixel.x(), pixel.y(), z));
  }
  return frame;
}

Colors ErringCamera::colors(const DepthRenderer& renderer, const SensorFrame& frame) const {
  if (options_.color_offset == 0.0) return frame.colors;
  Eigen::Isometry3d T_world_color = frame.T_world_camera;
  T_world_color.translate(Eigen::Vector3d(options_.color_offset, 0.0, 0.0));
  return renderer.render(camera_, T_world_color).colors;
}

}  // namespace symscene
