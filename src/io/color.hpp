#pragma once

#include <algorithm>
#include <cmath>

#include "symscene/core/types.hpp"

namespace symscene {

/// Rounds and clamps to [0, 255]; 0 for NaN.
inline std::uint8_t to_color(float value) {
  if (std::isnan(value)) return 0;
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 255.0F)));
}

/// N×3 values, multiplied by `scale`, as colours.
template <class Values>
Colors to_colors(const Values& values, float scale) {
  Colors colors(values.rows(), 3);
  for (Eigen::Index k = 0; k < 3; ++k) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) colors(i, k) = to_color(values(i, k) * scale);
  }
  return colors;
}

}  // namespace symscene
