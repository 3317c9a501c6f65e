#pragma once

#include <vector>

#include "simulation/depth_renderer.hpp"
#include "symscene/simulation/camera_errors.hpp"

namespace symscene {

/// A simulated camera with systematic errors. Rays per pixel are computed once.
class ErringCamera {
 public:
  /// Throws InputError if an option is out of its range.
  ErringCamera(const CameraIntrinsics& camera, const CameraErrorOptions& options);

  const CameraIntrinsics& intrinsics() const { return camera_; }

  /// The image without noise, with the camera's distortion and depth error. A pixel for which the
  /// lens shows nothing is not measured.
  SensorFrame render(const DepthRenderer& renderer, const Eigen::Isometry3d& T_world_camera) const;

  /// What the colour camera sees, if it is not in the same place; otherwise the colours of `frame`.
  Colors colors(const DepthRenderer& renderer, const SensorFrame& frame) const;

 private:
  CameraIntrinsics camera_;
  CameraErrorOptions options_;
  DepthBias bias_;
  std::vector<Eigen::Vector2d> rays_;  ///< per pixel; empty without distortion
};

}  // namespace symscene
