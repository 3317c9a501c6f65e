#include "features.hpp"

#include <algorithm>
#include <cmath>

#include "image_features.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr Index depth_reach = 2;  ///< of the depths that are compared around a feature [px]

void require_images(const DepthFrame& frame, const CameraIntrinsics& camera) {
  const auto require = [&](std::size_t pixels, const char* image) {
    if (pixels == camera.pixels()) return;
    throw InputError(image, std::to_string(camera.pixels()) + " pixels", std::to_string(pixels));
  };
  require(frame.depth.size(), "depth image");
  require(static_cast<std::size_t>(frame.colors.rows()), "colour image");
}

/// Luma of Rec. 601.
std::vector<std::uint8_t> gray_values(const Colors& colors) {
  std::vector<std::uint8_t> gray(static_cast<std::size_t>(colors.rows()));
  for (std::size_t i = 0; i < gray.size(); ++i) {
    const auto row = colors.row(static_cast<Eigen::Index>(i));
    const unsigned sum = 299U * row[0] + 587U * row[1] + 114U * row[2];
    gray[i] = static_cast<std::uint8_t>((sum + 500U) / 1000U);
  }
  return gray;
}

/// Decides where depth is known and smooth.
class SmoothDepth {
 public:
  SmoothDepth(const DepthFrame& frame, const CameraIntrinsics& camera, double step,
              const MeasurementOptions& sensor)
      : depth_(frame.depth), width_(camera.width), step_(step), sensor_(sensor) {}

  /// For pixels at least `depth_reach` from the image's border.
  bool at(Index u, Index v) const {
    const double z = depth(u, v);
    if (!(z >= sensor_.min_depth && z <= sensor_.max_depth)) return false;
    const double bound = step_ * z * std::max(z, 1.0);
    for (Index y = v - depth_reach; y <= v + depth_reach; ++y) {
      for (Index x = u - depth_reach; x <= u + depth_reach; ++x) {
        const double other = depth(x, y);
        // Single pixels without depth are common; a depth step is an outline.
        if (other > 0.0 && !(std::abs(other - z) <= bound)) return false;
      }
    }
    return true;
  }

 private:
  double depth(Index u, Index v) const {
    return static_cast<double>(depth_[std::size_t{v} * width_ + u]);
  }

  const std::vector<float>& depth_;
  Index width_;
  double step_;  ///< at 1 m [m]
  const MeasurementOptions& sensor_;
};

/// 255 where depth is known and smooth.
std::vector<std::uint8_t> surface_mask(const DepthFrame& frame, const CameraIntrinsics& camera,
                                       const FeatureOptions& options,
                                       const MeasurementOptions& sensor) {
  std::vector<std::uint8_t> mask(camera.pixels());
  if (camera.width <= 2 * depth_reach || camera.height <= 2 * depth_reach) return mask;
  const SmoothDepth smooth(frame, camera, options.depth_step, sensor);
  for (Index v = depth_reach; v < camera.height - depth_reach; ++v) {
    for (Index u = depth_reach; u < camera.width - depth_reach; ++u) {
      if (smooth.at(u, v)) mask[std::size_t{v} * camera.width + u] = 255;
    }
  }
  return mask;
}

/// The mean depth of 3×3 pixels, which is less noisy than one of them.
double mean_depth_around(const DepthFrame& frame, const CameraIntrinsics& camera,
                         const Eigen::Vector2d& pixel) {
  const auto clamped = [](double value, Index size) {
    return std::clamp(std::lround(value), 1L, static_cast<long>(size) - 2);
  };
  const long u = clamped(pixel.x(), camera.width), v = clamped(pixel.y(), camera.height);
  double sum = 0.0;
  int count = 0;
  for (long y = v - 1; y <= v + 1; ++y) {
    for (long x = u - 1; x <= u + 1; ++x) {
      const float z =
          frame.depth[static_cast<std::size_t>(y * static_cast<long>(camera.width) + x)];
      if (!(z > 0.0F && std::isfinite(z))) continue;
      sum += static_cast<double>(z);
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

/// The best and the second best of similarities.
struct Nearest {
  Index index = 0;
  float best = -1.0F;
  float second = -1.0F;

  void offer(Index candidate, float similarity) {
    if (similarity > best) {
      second = best;
      best = similarity;
      index = candidate;
    } else {
      second = std::max(second, similarity);
    }
  }
};

/// Distances of unit vectors from their cosine: d² = 2 − 2 cos.
bool distinct(const Nearest& nearest, double ratio) {
  const double near = 2.0 - 2.0 * static_cast<double>(nearest.best);
  const double next = 2.0 - 2.0 * static_cast<double>(nearest.second);
  return near < ratio * ratio * next;
}

}  // namespace

FrameFeatures find_features(const DepthFrame& frame, const CameraIntrinsics& camera,
                            const FeatureOptions& options, const MeasurementOptions& sensor) {
  options.validate();
  require_images(frame, camera);
  Keypoints found = find_keypoints(gray_values(frame.colors), camera,
                                   surface_mask(frame, camera, options, sensor), options);
  FrameFeatures features{std::move(found.pixels), {}, std::move(found.descriptors)};
  features.points_camera.resize(3, features.pixels.cols());
  for (Eigen::Index i = 0; i < features.pixels.cols(); ++i) {
    const Eigen::Vector2d pixel = features.pixels.col(i);
    features.points_camera.col(i) =
        mean_depth_around(frame, camera, pixel) * camera.ray(pixel.x(), pixel.y());
  }
  return features;
}

std::vector<FeatureMatch> match_features(const FrameFeatures& first, const FrameFeatures& second,
                                         const FeatureOptions& options) {
  std::vector<FeatureMatch> matches;
  if (first.size() == 0 || second.size() == 0) return matches;
  // Descriptors are whole numbers below 256: no order of summing rounds their products.
  const Eigen::MatrixXf products = first.descriptors.transpose() * second.descriptors;
  const Eigen::VectorXf norms = first.descriptors.colwise().norm().cwiseMax(1.0F);
  const Eigen::VectorXf others = second.descriptors.colwise().norm().cwiseMax(1.0F);
  std::vector<Nearest> of_first(first.size()), of_second(second.size());
  for (Eigen::Index j = 0; j < products.cols(); ++j) {
    for (Eigen::Index i = 0; i < products.rows(); ++i) {
      const float similarity = products(i, j) / (norms[i] * others[j]);
      of_first[static_cast<std::size_t>(i)].offer(static_cast<Index>(j), similarity);
      of_second[static_cast<std::size_t>(j)].offer(static_cast<Index>(i), similarity);
    }
  }
  for (std::size_t i = 0; i < of_first.size(); ++i) {
    const Nearest& there = of_first[i];
    const Nearest& back = of_second[there.index];
    if (back.index != i || !distinct(there, options.ratio) || !distinct(back, options.ratio)) {
      continue;
    }
    matches.push_back({static_cast<Index>(i), there.index});
  }
  return matches;
}

}  // namespace symscene
