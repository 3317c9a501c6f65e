#pragma once

#include "symscene/core/geometry.hpp"

namespace symscene {

/// The interval [min, max] of an angle or distance that maps to [0, 1], clamped outside it
/// (ramp()): 0 up to `min`, 1 from `max` on.
struct ScoreRange {
  double min = 0.0;
  double max = 1.0;

  float operator()(float value) const {
    return ramp(value, static_cast<float>(min), static_cast<float>(max));
  }
};

}  // namespace symscene
