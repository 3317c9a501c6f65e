#include "paint.hpp"

#include <algorithm>
#include <cmath>

namespace symscene {
namespace {

/// Red, green and blue in [0, 1] of a hue in [0, 1).
Eigen::Vector3d from_hue(double hue, double saturation, double value) {
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hue * 6.0, 6.0);
    return value - value * saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

}  // namespace

Colors paint(const Points& vertices, Random& random) {
  const double hue = random.uniform();
  const Eigen::Vector3d base = from_hue(hue, random.uniform(0.3, 0.85), random.uniform(0.55, 0.95));
  const Eigen::Vector3d second =
      from_hue(std::fmod(hue + random.uniform(0.3, 0.7), 1.0), 0.5, random.uniform(0.4, 0.95));
  const double height = std::max(1e-3, static_cast<double>(vertices.col(2).maxCoeff()));
  const double band_low = random.uniform(0.2, 0.5);
  const double band_high = band_low + random.uniform(0.15, 0.35);
  const double stripes = random.uniform(80.0, 200.0);
  const Eigen::Vector3d mottle(random.uniform(60, 160), random.uniform(60, 160),
                               random.uniform(60, 160));

  Colors colors(vertices.rows(), 3);
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) {
    const Eigen::Vector3d p = vertices.row(i).transpose().cast<double>();
    const bool in_band = p.z() > band_low * height && p.z() < band_high * height;
    const double shade = 1.0 + 0.06 * std::sin(stripes * p.z()) +
                         0.05 * std::sin(mottle.x() * p.x()) * std::sin(mottle.y() * p.y()) *
                             std::sin(mottle.z() * p.z() + 1.0);
    const Eigen::Vector3d color = shade * (in_band ? second : base);
    for (int c = 0; c < 3; ++c) {
      colors(i, c) = static_cast<std::uint8_t>(std::clamp(255.0 * color[c], 0.0, 255.0));
    }
  }
  return colors;
}

}  // namespace symscene
