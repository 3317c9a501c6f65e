#include <algorithm>
#include <cmath>

#include "core/image_checks.hpp"
#include "symscene/labels/label_image.hpp"

namespace symscene {
namespace {

/// Hues a golden angle apart, so that labels with close numbers differ.
Eigen::Vector3d label_color(std::uint16_t label) {
  constexpr double golden = 0.6180339887;
  const double hue = 6.0 * std::fmod(golden * label, 1.0);
  const auto channel = [&](double shift) {
    return 255.0 * std::clamp(std::abs(std::fmod(hue + shift, 6.0) - 3.0) - 1.0, 0.0, 1.0);
  };
  return {channel(0.0), channel(4.0), channel(2.0)};
}

/// Near depths are bright; unmeasured pixels are black.
Colors grey_depths(const std::vector<float>& depth) {
  float near = std::numeric_limits<float>::max(), far = 0.0F;
  for (const float z : depth) {
    if (z <= 0.0F) continue;
    near = std::min(near, z);
    far = std::max(far, z);
  }
  Colors grey = Colors::Zero(static_cast<Eigen::Index>(depth.size()), 3);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] <= 0.0F) continue;
    const float share = far > near ? (far - depth[i]) / (far - near) : 1.0F;
    grey.row(static_cast<Eigen::Index>(i)).setConstant(static_cast<std::uint8_t>(60 + 195 * share));
  }
  return grey;
}

}  // namespace

Colors overlay(const CameraIntrinsics& camera, const DepthFrame& frame,
               std::span<const std::uint16_t> labels) {
  require_pixels(labels.size(), camera, "labels");
  require_pixels(frame.depth.size(), camera, "depth image");
  Colors colors = frame.colors.rows() == 0 ? grey_depths(frame.depth) : frame.colors;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == 0) continue;
    const bool is_border = (i % camera.width > 0 && labels[i - 1] != labels[i]) ||
                           (i >= camera.width && labels[i - camera.width] != labels[i]);
    const double share = is_border ? 1.0 : 0.5;
    auto pixel = colors.row(static_cast<Eigen::Index>(i));
    const Eigen::Vector3d mixed =
        (1.0 - share) * pixel.transpose().cast<double>() + share * label_color(labels[i]);
    pixel = mixed.transpose().cast<std::uint8_t>();
  }
  return colors;
}

}  // namespace symscene
