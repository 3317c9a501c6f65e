#pragma once

#include "symscene/core/error.hpp"

namespace symscene {

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
