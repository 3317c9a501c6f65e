#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace symscene {

/// Converts metres to whole millimetres; 0 where there is no measurement or it exceeds 16 bits.
inline std::vector<std::uint16_t> to_millimetres(const std::vector<float>& depth) {
  std::vector<std::uint16_t> values(depth.size());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const float millimetres = std::round(depth[i] * 1000.0F);
    const bool fits = millimetres >= 0.0F && millimetres <= 65535.0F;  // false for NaN
    values[i] = fits ? static_cast<std::uint16_t>(millimetres) : std::uint16_t{0};
  }
  return values;
}

}  // namespace symscene
