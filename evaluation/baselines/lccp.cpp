#include "symscene/baselines/lccp.hpp"

#include "core/evenly_spaced.hpp"
#include "lccp_labels.hpp"
#include "oriented_input.hpp"
#include "segmentation/segments_of_labels.hpp"
#include "symscene/core/error.hpp"

namespace symscene {

void LccpOptions::validate() const {
  check_fields(*this);
  require_option(seed_spacing >= voxel_size, "seed_spacing", "at least voxel_size", seed_spacing);
}

std::vector<PointIndices> lccp_segments(const PointCloud& cloud, const LccpOptions& options) {
  return lccp_sweep(cloud, options, {options.concavity_tolerance}).masks.front();
}

BaselineSweep lccp_sweep(const PointCloud& cloud, const LccpOptions& options,
                         std::vector<double> tolerances) {
  if (!has_lccp())
    throw InputError("LCCP", "a build with PCL (install libpcl-dev and build again)",
                     "one without");
  if (tolerances.empty()) {
    for (const double angle : evenly_spaced(10.0, 70.0, 5.0)) tolerances.push_back(radians(angle));
  }
  LccpOptions checked = options;
  for (const double tolerance : tolerances) {
    checked.concavity_tolerance = tolerance;
    checked.validate();
  }
  require_oriented(cloud);
  BaselineSweep sweep{"LCCP", "concavity_tolerance", std::move(tolerances), {}};
  sweep.masks.resize(sweep.values.size());
  if (cloud.empty()) return sweep;
  const std::vector<std::vector<Index>> labels = lccp_labels(cloud, options, sweep.values);
  for (std::size_t i = 0; i < labels.size(); ++i)
    sweep.masks[i] = segments_of_labels(labels[i], options.min_size);
  return sweep;
}

}  // namespace symscene
