#include "depth_samples.hpp"

#include <algorithm>
#include <cmath>

#include "core/median.hpp"

namespace symscene {
namespace {

constexpr float agreement = 0.02F;  ///< of the depths of one surface in a block, over their median

struct Block {
  PixelSpan columns, rows;
  std::size_t pixels() const {
    return std::size_t{columns.end - columns.begin} * (rows.end - rows.begin);
  }
};

std::optional<DepthSample> sample_of(const std::vector<float>& depth, Index width,
                                     const Block& block) {
  std::vector<float> inverse;
  const auto for_each_measured = [&](const auto& visit) {
    for (Index v = block.rows.begin; v < block.rows.end; ++v) {
      for (Index u = block.columns.begin; u < block.columns.end; ++u) {
        const float z = depth[std::size_t{v} * width + u];
        if (z > 0.0F) visit(u, v, 1.0F / z);
      }
    }
  };
  for_each_measured([&](Index, Index, float value) { inverse.push_back(value); });
  if (2 * inverse.size() < block.pixels() || inverse.empty()) return std::nullopt;
  const float middle = *median(std::move(inverse));
  double u_sum = 0.0, v_sum = 0.0, sum = 0.0;
  std::size_t count = 0;
  for_each_measured([&](Index u, Index v, float value) {
    if (std::abs(value - middle) > agreement * middle) return;
    u_sum += u, v_sum += v, sum += value, ++count;
  });
  if (2 * count < block.pixels()) return std::nullopt;
  const auto n = static_cast<double>(count);
  return DepthSample{static_cast<float>(u_sum / n), static_cast<float>(v_sum / n),
                     static_cast<float>(n / sum)};
}

}  // namespace

PixelSpan pixel_span(Index i, Index count, Index size) {
  const auto at = [&](Index k) { return static_cast<Index>(std::uint64_t{k} * size / count); };
  return {at(i), at(i + 1)};
}

std::vector<DepthSample> depth_samples(const std::vector<float>& depth,
                                       const CameraIntrinsics& camera,
                                       const DepthCorrectionOptions& grid) {
  const Index columns = std::min(camera.width, static_cast<Index>(grid.columns * grid.samples));
  const Index rows = std::min(camera.height, static_cast<Index>(grid.rows * grid.samples));
  std::vector<DepthSample> samples;
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Block block{pixel_span(i, columns, camera.width), pixel_span(j, rows, camera.height)};
      if (const auto sample = sample_of(depth, camera.width, block)) samples.push_back(*sample);
    }
  }
  return samples;
}

}  // namespace symscene
