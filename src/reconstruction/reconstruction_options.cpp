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
  require_option(zero_weight_sigmas > full_weight_sigmas, "full_weight_sigmas",
                 "less than zero_weight_sigmas", full_weight_sigmas);
}

}  // namespace symscene
