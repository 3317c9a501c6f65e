#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/random.hpp"
#include "symscene/core/camera.hpp"

namespace symscene {

/// Correlated normal noise of variance one: drawn on a grid and interpolated.
class GrainyNoise {
 public:
  GrainyNoise(const CameraIntrinsics& camera, double grain, Random& random)
      : grain_(grain), columns_(static_cast<std::size_t>(camera.width / grain) + 2) {
    const std::size_t rows = static_cast<std::size_t>(camera.height / grain) + 2;
    for (std::size_t i = 0; i < rows * columns_; ++i) values_.push_back(random.normal());
  }

  double at(Index u, Index v) const {
    const double x = u / grain_, y = v / grain_;
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const double fx = x - static_cast<double>(column), fy = y - static_cast<double>(row);
    const double* first = values_.data() + row * columns_ + column;
    const double* second = first + columns_;
    const double sum = (1 - fy) * ((1 - fx) * first[0] + fx * first[1]) +
                       fy * ((1 - fx) * second[0] + fx * second[1]);
    const double power = (fx * fx + (1 - fx) * (1 - fx)) * (fy * fy + (1 - fy) * (1 - fy));
    return sum / std::sqrt(power);  // interpolation lowers the variance between grid points
  }

 private:
  double grain_;
  std::size_t columns_;
  std::vector<double> values_;
};

}  // namespace symscene
