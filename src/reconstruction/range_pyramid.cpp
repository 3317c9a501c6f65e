#include "range_pyramid.hpp"

#include <algorithm>
#include <bit>

#include "core/dispatch.hpp"

namespace symscene {
namespace {

/// The smallest value of every 2×2 pixels of two rows.
SYMSCENE_MULTIVERSION
void least_of_four(const float* upper, const float* lower, std::size_t count, float* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const float a = std::min(upper[2 * i], upper[2 * i + 1]);
    const float b = std::min(lower[2 * i], lower[2 * i + 1]);
    out[i] = std::min(a, b);
  }
}

/// The largest one.
SYMSCENE_MULTIVERSION
void greatest_of_four(const float* upper, const float* lower, std::size_t count, float* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const float a = std::max(upper[2 * i], upper[2 * i + 1]);
    const float b = std::max(lower[2 * i], lower[2 * i + 1]);
    out[i] = std::max(a, b);
  }
}

}  // namespace

RangePyramid::RangePyramid(std::vector<float> values, std::size_t width, std::size_t height) {
  levels_.push_back({width, height, std::move(values), {}});
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    levels_.push_back(halved(levels_.back()));
  }
  max_ = levels_.back().maxima()[0];
}

RangePyramid::Level RangePyramid::halved(const Level& fine) {
  Level coarse;
  coarse.width = (fine.width + 1) / 2;
  coarse.height = (fine.height + 1) / 2;
  coarse.min.resize(coarse.width * coarse.height);
  coarse.max.resize(coarse.width * coarse.height);
  const std::size_t pairs = fine.width / 2;
  for (std::size_t v = 0; v < coarse.height; ++v) {
    const std::size_t upper = 2 * v * fine.width;
    const std::size_t lower = std::min(2 * v + 1, fine.height - 1) * fine.width;
    const float* minima = fine.min.data();
    const float* maxima = fine.maxima().data();
    float* const min_row = coarse.min.data() + v * coarse.width;
    float* const max_row = coarse.max.data() + v * coarse.width;
    least_of_four(minima + upper, minima + lower, pairs, min_row);
    greatest_of_four(maxima + upper, maxima + lower, pairs, max_row);
    if (pairs < coarse.width) {
      const std::size_t last = fine.width - 1;
      min_row[pairs] = std::min(minima[upper + last], minima[lower + last]);
      max_row[pairs] = std::max(maxima[upper + last], maxima[lower + last]);
    }
  }
  return coarse;
}

RangePyramid::Range RangePyramid::bounds(const Rectangle& pixels) const {
  const auto span =
      static_cast<unsigned>(std::max(pixels.high_u - pixels.low_u, pixels.high_v - pixels.low_v));
  // Four or five cells across: tight bounds from few cells.
  const int level = std::clamp(static_cast<int>(std::bit_width(span)) - 2, 0,
                               static_cast<int>(levels_.size()) - 1);
  const Level& cells = levels_[static_cast<std::size_t>(level)];
  const std::vector<float>& maxima = cells.maxima();
  Range range{cells.min[0], -1.0F};
  bool first = true;
  for (int v = pixels.low_v >> level; v <= pixels.high_v >> level; ++v) {
    for (int u = pixels.low_u >> level; u <= pixels.high_u >> level; ++u) {
      const std::size_t i = static_cast<std::size_t>(v) * cells.width + static_cast<std::size_t>(u);
      range.min = first ? cells.min[i] : std::min(range.min, cells.min[i]);
      range.max = first ? maxima[i] : std::max(range.max, maxima[i]);
      first = false;
    }
  }
  return range;
}

}  // namespace symscene
