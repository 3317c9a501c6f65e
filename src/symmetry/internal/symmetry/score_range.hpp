#pragma once

#include "symscene/core/error.hpp"
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

/// The intervals of the options of detection and segmentation.
template <class Options>
ScoreRange angle_range(const Options& options) {
  return {options.min_angle, options.max_angle};
}
template <class Options>
ScoreRange occlusion_range(const Options& options) {
  return {options.min_occlusion, options.max_occlusion};
}

/// Throws InputError unless min_angle < max_angle and min_occlusion < max_occlusion, the intervals
/// of angles (symmetry) and distances (occlusion) that detection and segmentation use.
template <class Options>
void require_score_ranges(const Options& options) {
  require_option(options.min_angle < options.max_angle, "max_angle", "an angle above min_angle",
                 options.max_angle);
  require_option(options.min_occlusion < options.max_occlusion, "max_occlusion",
                 "a distance above min_occlusion", options.max_occlusion);
}

}  // namespace symscene
