#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "symscene/core/camera.hpp"
#include "symscene/core/depth_correction.hpp"
#include "symscene/core/lens_distortion.hpp"

namespace symscene {

/// A colour camera beside a depth camera.
struct ColorCamera {
  CameraIntrinsics intrinsics;
  LensDistortion distortion;
  Eigen::Isometry3d T_depth_color = Eigen::Isometry3d::Identity();  ///< its pose [m]
};

/// A calibrated depth camera. Without distortion, correction and colour camera it is a pinhole
/// camera whose depths are true and whose colours belong to its pixels.
struct CameraModel {
  CameraIntrinsics intrinsics;
  LensDistortion distortion;
  std::optional<DepthCorrection> depth_correction;
  std::optional<ColorCamera> color;  ///< none: colours are registered to the depth
};

}  // namespace symscene
