#pragma once

#include <Eigen/Geometry>

#include "symscene/core/camera.hpp"

namespace symscene {

/// Points that two cameras have measured, and where each saw them. One a column.
struct SharedPoints {
  Eigen::Matrix3Xd points_first, points_second;  ///< in the frame of the camera [m]
  Eigen::Matrix2Xd pixels_first, pixels_second;  ///< [px]
};

/// The points of each camera as the other would see them, less what it saw. [px]
Eigen::Vector2d error_in_first(const SharedPoints& shared, Eigen::Index i,
                               const CameraIntrinsics& camera,
                               const Eigen::Isometry3d& T_first_second);
Eigen::Vector2d error_in_second(const SharedPoints& shared, Eigen::Index i,
                                const CameraIntrinsics& camera,
                                const Eigen::Isometry3d& T_first_second);

/// The pose that makes these errors small, by Gauss-Newton from `T_first_second` under Cauchy's
/// function with this scale. [px]
Eigen::Isometry3d refine_by_reprojection(const SharedPoints& shared, const CameraIntrinsics& camera,
                                         Eigen::Isometry3d T_first_second, double scale);

}  // namespace symscene
