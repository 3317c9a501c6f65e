#pragma once

#include <memory>
#include <span>

#include "symscene/core/triangle_mesh.hpp"
#include "symscene/simulation/sensor_frame.hpp"

namespace symscene {

/// Renders depth images of meshes by ray casting. render() may be called from many threads at once.
class DepthRenderer {
 public:
  /// Copies the meshes; frames refer to them by their number in the span.
  explicit DepthRenderer(std::span<const TriangleMesh> meshes);
  ~DepthRenderer();
  DepthRenderer(DepthRenderer&&) noexcept;
  DepthRenderer& operator=(DepthRenderer&&) noexcept;

  /// The image without noise: depth at pixel centres, colours shaded by a light at the camera.
  SensorFrame render(const CameraIntrinsics& camera, const Eigen::Isometry3d& T_world_camera) const;
  /// The same with other rays: x and y of one with z = 1 per pixel, not finite where there is none.
  /// Empty: those of the camera.
  SensorFrame render(const CameraIntrinsics& camera, const Eigen::Isometry3d& T_world_camera,
                     std::span<const Eigen::Vector2d> rays) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
