#include "depth_bounds.hpp"

#include <algorithm>

namespace symscene {

DepthBounds::DepthBounds(const Measurement& measurement)
    : columns_((measurement.camera.width + tile - 1) / tile),
      rows_((measurement.camera.height + tile - 1) / tile),
      farthest_(std::size_t{columns_} * rows_) {
  const Index width = measurement.camera.width;
  for (Index v = 0; v < measurement.camera.height; ++v) {
    const std::uint32_t* row = measurement.packed.data() + std::size_t{v} * width;
    float* bounds = farthest_.data() + std::size_t{v / tile} * columns_;
    for (Index u = 0; u < width; u += tile) {
      std::uint32_t most = 0;
      for (Index k = u; k < std::min(width, u + tile); ++k) most = std::max(most, row[k]);
      const float depth = static_cast<float>(most >> 16) * Measurement::depth_unit;
      bounds[u / tile] = std::max(bounds[u / tile], depth);
    }
  }
}

float DepthBounds::anywhere() const {
  return *std::max_element(farthest_.begin(), farthest_.end());
}

float DepthBounds::around(float u, float v, float radius) const {
  const auto clamped = [](float at, Index count) {
    return static_cast<Index>(
        std::clamp(at / static_cast<float>(tile), 0.0F, static_cast<float>(count - 1)));
  };
  const auto right = static_cast<float>(columns_ * tile);
  const auto bottom = static_cast<float>(rows_ * tile);
  if (u + radius < 0.0F || v + radius < 0.0F || u - radius > right || v - radius > bottom) {
    return 0.0F;
  }
  float most = 0.0F;
  for (Index y = clamped(v - radius, rows_); y <= clamped(v + radius, rows_); ++y) {
    for (Index x = clamped(u - radius, columns_); x <= clamped(u + radius, columns_); ++x) {
      most = std::max(most, farthest_[std::size_t{y} * columns_ + x]);
    }
  }
  return most;
}

}  // namespace symscene
