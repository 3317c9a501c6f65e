#pragma once

#include <vector>

#include "reconstruction/measurement.hpp"

namespace symscene {

/// The largest depth in every tile of a measurement, 0 where none was measured. [m]
class DepthBounds {
 public:
  explicit DepthBounds(const Measurement& measurement);

  float anywhere() const;

  /// The largest depth of the tiles that a disc of pixels touches, 0 outside the image. [m]
  float around(float u, float v, float radius) const;

 private:
  static constexpr Index tile = 16;  ///< [px]

  Index columns_, rows_;
  std::vector<float> farthest_;
};

}  // namespace symscene
