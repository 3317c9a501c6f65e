#pragma once

#include <vector>

#include "symscene/stitching/stitching.hpp"

namespace symscene {

/// The features of an image and the points of the surface that they show.
struct FrameFeatures {
  Eigen::Matrix2Xd pixels;         ///< [px]
  Eigen::Matrix3Xd points_camera;  ///< what the pixels show [m]
  Eigen::MatrixXf descriptors;     ///< one per column

  std::size_t size() const { return static_cast<std::size_t>(pixels.cols()); }
};

/// SIFT features (Lowe 2004) of a frame's grey values where its depth is known and smooth. Throws
/// InputError if the frame has no colours, the images are not of the camera's size, or the build
/// has no OpenCV.
FrameFeatures find_features(const DepthFrame& frame, const CameraIntrinsics& camera,
                            const FeatureOptions& options, const MeasurementOptions& sensor);

/// Pairs of features that are each other's nearest descriptor and pass the ratio test, by ascending
/// `first`.
std::vector<FeatureMatch> match_features(const FrameFeatures& first, const FrameFeatures& second,
                                         const FeatureOptions& options);

}  // namespace symscene
