#pragma once

#include <span>
#include <vector>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/options.hpp"
#include "symscene/reconstruction/measurement.hpp"

namespace symscene {

struct FeatureOptions {
  int max_features = 1500;   ///< of an image, the strongest
  double contrast = 0.01;    ///< least contrast of a feature (SIFT, Lowe 2004, section 4)
  double ratio = 0.85;       ///< of the nearest to the second nearest descriptor (section 7.1)
  double depth_step = 0.03;  ///< largest depth difference about a feature, at 1 m: what lies on an
                             ///< object's outline moves over the surface with the view [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_features", self.max_features, "", "features of an image, the strongest");
    visit("contrast", self.contrast, "", "least contrast of a feature");
    visit("ratio", self.ratio, "", "of the nearest to the second nearest descriptor");
    visit("depth_step", self.depth_step, "m", "largest depth difference about a feature, at 1 m");
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

/// What is told again in another image: places on the surface with what they look like.
struct ImageFeatures {
  Eigen::Matrix2Xd pixels;         ///< [px]
  Eigen::Matrix3Xd points_camera;  ///< what the pixels show [m]
  Eigen::MatrixXf descriptors;     ///< one a column

  std::size_t size() const { return static_cast<std::size_t>(pixels.cols()); }
};

/// A feature of one image and one of another that look alike.
struct FeatureMatch {
  Index first = 0;
  Index second = 0;
};

/// Whether this build has OpenCV, which find_features and the poses of pairs take.
bool has_feature_matcher();

/// SIFT features (Lowe 2004) of a frame's grey values where its depth is known and smooth. Throws
/// InputError if the frame has no colours, the images are not of the camera's size, or the build
/// has no OpenCV.
ImageFeatures find_features(const DepthFrame& frame, const CameraIntrinsics& camera,
                            const FeatureOptions& options, const MeasurementOptions& sensor);

/// Features that are each other's nearest in appearance, and by far: by rising `first`.
std::vector<FeatureMatch> match_features(const ImageFeatures& first, const ImageFeatures& second,
                                         const FeatureOptions& options);

}  // namespace symscene
