#include <algorithm>

#include "symscene/core/error.hpp"
#include "symscene/reconstruction/measurement_options.hpp"
#include "symscene/reconstruction/surface_options.hpp"

namespace symscene {

void MeasurementOptions::validate() const {
  check_fields(*this);
  require_option(max_depth > min_depth, "max_depth", "more than min_depth", max_depth);
}

void TsdfOptions::validate() const {
  check_fields(*this);
  require_option(truncation >= 2 * voxel_size, "truncation", "at least two voxels", truncation);
  require_option(max_truncation >= truncation, "max_truncation", "at least truncation",
                 max_truncation);
  // Their difference is a divisor in single precision.
  require_option(zero_weight_behind - full_weight_behind >= 0.01, "full_weight_behind",
                 "0.01 or more below zero_weight_behind", full_weight_behind);
}

SurfaceExtractionOptions surface_of_few(const SurfaceExtractionOptions& options,
                                        std::size_t frames) {
  constexpr double smallest_weight = 1.0 / 16.0;  // of a measurement
  SurfaceExtractionOptions few = options;
  const double share = std::min(1.0, static_cast<double>(frames) / options.full_frames);
  few.min_weight =
      std::min(options.min_weight, std::max(smallest_weight, share * options.min_weight));
  return few;
}

}  // namespace symscene
