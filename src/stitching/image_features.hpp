#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "features.hpp"

// The functions that need OpenCV; features_opencv.cpp, the only file that includes it, has them.
namespace symscene {

/// SIFT keypoints of a grey image, strongest first.
struct Keypoints {
  Eigen::Matrix2Xd pixels;
  Eigen::MatrixXf descriptors;  ///< one per column
};
Keypoints find_keypoints(const std::vector<std::uint8_t>& gray, const CameraIntrinsics& camera,
                         const std::vector<std::uint8_t>& mask, const FeatureOptions& options);

/// The pose of a camera that sees points at pixels, by PnP with RANSAC, and its inliers.
struct SeenFrom {
  Eigen::Isometry3d T_camera_points = Eigen::Isometry3d::Identity();
  std::vector<Index> inliers;  ///< ascending
};
std::optional<SeenFrom> solve_perspective(const Eigen::Matrix3Xd& points,
                                          const Eigen::Matrix2Xd& pixels,
                                          const CameraIntrinsics& camera,
                                          const PairOptions& options);

}  // namespace symscene
