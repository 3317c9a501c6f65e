#pragma once

#include <Eigen/Geometry>

#include "symscene/core/camera.hpp"

namespace symscene {

/// Points that two cameras have measured, and their pixels in both. One per column.
struct SharedPoints {
  Eigen::Matrix3Xd points_first, points_second;  ///< in the frame of the camera [m]
  Eigen::Matrix2Xd pixels_first, pixels_second;  ///< [px]
};

/// Reprojection errors of the points of one camera in the image of the other. [px]
Eigen::Vector2d error_in_first(const SharedPoints& shared, Eigen::Index i,
                               const CameraIntrinsics& camera,
                               const Eigen::Isometry3d& T_first_second);
Eigen::Vector2d error_in_second(const SharedPoints& shared, Eigen::Index i,
                                const CameraIntrinsics& camera,
                                const Eigen::Isometry3d& T_first_second);

/// The pose that minimises these errors by Gauss-Newton from `T_first_second`, with Cauchy's
/// weights of this scale. [px]
Eigen::Isometry3d refine_by_reprojection(const SharedPoints& shared, const CameraIntrinsics& camera,
                                         Eigen::Isometry3d T_first_second, double scale);

}  // namespace symscene
