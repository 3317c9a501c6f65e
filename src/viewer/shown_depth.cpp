#include "symscene/viewer/shown_depth.hpp"

#include <algorithm>
#include <cmath>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// The image with fewer pixels, 0 where nothing was measured.
std::vector<float> coarse_depth(std::span<const float> depth, const CameraIntrinsics& camera,
                                std::size_t coarser, const ShownDepth& size) {
  std::vector<float> coarse(size.width * size.height, 0.0F);
  const auto width = static_cast<std::size_t>(camera.width);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const std::size_t u = coarser * (i % size.width), v = coarser * (i / size.width);
    for (std::size_t k = 0; k < coarser * coarser; ++k) {
      const float value = depth[((v + k / coarser) * width) + u + (k % coarser)];
      if (value > 0.0F && (coarse[i] == 0.0F || value < coarse[i])) coarse[i] = value;
    }
  }
  return coarse;
}

}  // namespace

ShownDepth shown_depth(std::span<const float> depth, const CameraIntrinsics& camera,
                       std::size_t coarser) {
  const auto width = static_cast<std::size_t>(camera.width);
  const auto height = static_cast<std::size_t>(camera.height);
  if (coarser == 0 || depth.size() != width * height)
    throw InputError("a depth image to show", "one value per pixel", "another number");
  ShownDepth shown{width / coarser, height / coarser, {}};
  const std::vector<float> coarse = coarse_depth(depth, camera, coarser, shown);
  float least = 0.0F, most = 0.0F;
  for (const float value : coarse) {
    if (!(value > 0.0F)) continue;
    least = least == 0.0F ? value : std::min(least, value);
    most = std::max(most, value);
  }
  for (const float value : coarse) {
    const float share = (most - value) / std::max(most - least, 1e-6F);
    shown.nearness.push_back(
        value > 0.0F ? static_cast<std::uint8_t>(std::lround(1.0F + 254.0F * share)) : 0);
  }
  return shown;
}

}  // namespace symscene
