#include "symscene/simulation/camera_errors.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace symscene {

DepthBias::DepthBias(const CameraErrorOptions& options, const CameraIntrinsics& camera)
    : camera_(camera), at_2m_(options.depth_bias) {
  Random random(options.bias_pattern);
  for (int i = 0; i < waves; ++i) {
    // The first wave is a constant: the mean of the error.
    const double reach = i == 0 ? 0.0 : 0.9;
    waves_.col(i) << random.uniform(0.5, 1.0), random.uniform(-reach, reach),
        random.uniform(-reach, reach), random.uniform(0.0, 2.0 * std::numbers::pi);
  }
  waves_.row(0) /= waves_.row(0).sum();
}

double DepthBias::factor(double u, double v, double depth) const {
  if (at_2m_ == 0.0) return 1.0;
  const double x = (2.0 * u + 1.0) / camera_.width - 1.0;
  const double y = (2.0 * v + 1.0) / camera_.height - 1.0;
  double sum = 0.0;
  for (int i = 0; i < waves; ++i) {
    const auto wave = waves_.col(i);
    sum += wave[0] * std::cos(std::numbers::pi * (wave[1] * x + wave[2] * y) + wave[3]);
  }
  return 1.0 + at_2m_ * (depth / 2.0) * sum;
}

}  // namespace symscene
