#include "core/twist.hpp"
#include "image_features.hpp"
#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_OPENCV
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>

#include "core/opencv_memory.hpp"
#endif

namespace symscene {

#ifndef SYMSCENE_HAS_OPENCV

namespace {

[[noreturn]] void throw_no_matcher() {
  throw InputError("stitching",
                   "a build with a feature matcher (install libopencv-features2d-dev and "
                   "libopencv-calib3d-dev and build again)",
                   "one without");
}

}  // namespace

bool has_feature_matcher() { return false; }

Keypoints find_keypoints(const std::vector<std::uint8_t>&, const CameraIntrinsics&,
                         const std::vector<std::uint8_t>&, const FeatureOptions&) {
  throw_no_matcher();
}

std::optional<SeenFrom> solve_perspective(const Eigen::Matrix3Xd&, const Eigen::Matrix2Xd&,
                                          const CameraIntrinsics&, const PairOptions&) {
  throw_no_matcher();
}

#else

namespace {

/// A view of the pixels; OpenCV does not write to them.
cv::Mat image_of(const std::vector<std::uint8_t>& pixels, const CameraIntrinsics& camera) {
  return {static_cast<int>(camera.height), static_cast<int>(camera.width), CV_8UC1,
          const_cast<std::uint8_t*>(pixels.data())};
}

/// By strength; ties by position, so that the order of threads does not matter.
std::vector<std::size_t> strongest(const std::vector<cv::KeyPoint>& keypoints, std::size_t count) {
  std::vector<std::size_t> order(keypoints.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::size_t i) {
    const cv::KeyPoint& k = keypoints[i];
    return std::tuple(-k.response, k.pt.y, k.pt.x, k.size, k.angle);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  order.resize(std::min(order.size(), count));
  return order;
}

cv::Matx33d camera_matrix(const CameraIntrinsics& camera) {
  return {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
}

Eigen::Isometry3d to_pose(const cv::Vec3d& rotation, const cv::Vec3d& translation) {
  Vector6d twist;
  twist << rotation[0], rotation[1], rotation[2], translation[0], translation[1], translation[2];
  return motion(twist);
}

}  // namespace

bool has_feature_matcher() { return true; }

Keypoints find_keypoints(const std::vector<std::uint8_t>& gray, const CameraIntrinsics& camera,
                         const std::vector<std::uint8_t>& mask, const FeatureOptions& options) try {
  constexpr int layers = 3;
  const auto sift = cv::SIFT::create(0, layers, options.contrast);
  const cv::Mat image = image_of(gray, camera);
  std::vector<cv::KeyPoint> all, kept;
  sift->detect(image, all, image_of(mask, camera));
  for (const std::size_t i : strongest(all, static_cast<std::size_t>(options.max_features))) {
    kept.push_back(all[i]);
  }
  Keypoints found;
  if (kept.empty()) return found;
  cv::Mat descriptors;
  sift->compute(image, kept, descriptors);
  found.pixels.resize(2, static_cast<Eigen::Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    found.pixels.col(static_cast<Eigen::Index>(i)) << static_cast<double>(kept[i].pt.x),
        static_cast<double>(kept[i].pt.y);
  }
  found.descriptors = Eigen::Map<const Eigen::MatrixXf>(descriptors.ptr<float>(), descriptors.cols,
                                                        descriptors.rows);
  return found;
} catch (const cv::Exception& error) {
  rethrow_opencv(error);
}

std::optional<SeenFrom> solve_perspective(const Eigen::Matrix3Xd& points,
                                          const Eigen::Matrix2Xd& pixels,
                                          const CameraIntrinsics& camera,
                                          const PairOptions& options) try {
  std::vector<cv::Point3d> objects;
  std::vector<cv::Point2d> images;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    objects.emplace_back(points(0, i), points(1, i), points(2, i));
    images.emplace_back(pixels(0, i), pixels(1, i));
  }
  cv::Vec3d rotation, translation;
  std::vector<int> inliers;
  // Its random numbers are its own and start from the same seed in every call.
  const bool found = cv::solvePnPRansac(objects, images, camera_matrix(camera), cv::noArray(),
                                        rotation, translation, false, options.iterations,
                                        static_cast<float>(options.reprojection),
                                        options.confidence, inliers, cv::SOLVEPNP_AP3P);
  if (!found || !cv::checkRange(rotation) || !cv::checkRange(translation)) return {};
  SeenFrom seen{to_pose(rotation, translation), {inliers.begin(), inliers.end()}};
  std::sort(seen.inliers.begin(), seen.inliers.end());
  return seen;
} catch (const cv::Exception& error) {
  rethrow_opencv(error);
}

#endif

}  // namespace symscene
