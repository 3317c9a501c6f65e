#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "symscene/stitching/pair_pose.hpp"

// What OpenCV does: the one file that includes it, features_opencv.cpp, implements these.
namespace symscene {

/// SIFT keypoints of a grey image, strongest first.
struct Keypoints {
  Eigen::Matrix2Xd pixels;
  Eigen::MatrixXf descriptors;  ///< one a column
};
Keypoints find_keypoints(const std::vector<std::uint8_t>& gray, const CameraIntrinsics& camera,
                         const std::vector<std::uint8_t>& mask, const FeatureOptions& options);

/// The camera that sees points at pixels, by RANSAC, and which of them agree.
struct SeenFrom {
  Eigen::Isometry3d T_camera_points = Eigen::Isometry3d::Identity();
  std::vector<Index> inliers;  ///< ascending
};
std::optional<SeenFrom> solve_perspective(const Eigen::Matrix3Xd& points,
                                          const Eigen::Matrix2Xd& pixels,
                                          const CameraIntrinsics& camera,
                                          const PairOptions& options);

}  // namespace symscene
