#include "symscene/baselines/lccp.hpp"

#include <numbers>

#include "lccp_labels.hpp"
#include "segments.hpp"
#include "symscene/core/error.hpp"

namespace symscene {

void LccpOptions::validate() const {
  require_option(concavity_tolerance >= 0.0 && concavity_tolerance <= std::numbers::pi,
                 "concavity_tolerance", "an angle in [0, pi] rad", concavity_tolerance);
  require_option(voxel_size > 0.0, "voxel_size", "a length above 0 m", voxel_size);
  require_option(seed_spacing >= voxel_size, "seed_spacing", "at least the voxel size",
                 seed_spacing);
  require_option(spatial_importance >= 0.0, "spatial_importance", "at least 0", spatial_importance);
  require_option(normal_importance >= 0.0, "normal_importance", "at least 0", normal_importance);
  require_option(smoothness >= 0.0, "smoothness", "at least 0 voxels", smoothness);
  require_option(min_size >= 1, "min_size", "at least 1 point", min_size);
}

std::vector<PointIndices> lccp_segments(const PointCloud& cloud, const LccpOptions& options) {
  return lccp_sweep(cloud, options, {options.concavity_tolerance}).segments.front();
}

BaselineSweep lccp_sweep(const PointCloud& cloud, const LccpOptions& options,
                         std::vector<double> tolerances) {
  if (!has_lccp())
    throw InputError("LCCP", "a build with PCL (install libpcl-dev and build again)",
                     "one without");
  if (tolerances.empty()) {
    for (const double angle : parameter_grid(10.0, 70.0, 5.0)) tolerances.push_back(radians(angle));
  }
  LccpOptions checked = options;
  for (const double tolerance : tolerances) {
    checked.concavity_tolerance = tolerance;
    checked.validate();
  }
  require_oriented(cloud);
  BaselineSweep sweep{"LCCP", "concavity_tolerance", std::move(tolerances), {}};
  sweep.segments.resize(sweep.values.size());
  if (cloud.empty()) return sweep;
  const std::vector<std::vector<Index>> labels = lccp_labels(cloud, options, sweep.values);
  for (std::size_t i = 0; i < labels.size(); ++i)
    sweep.segments[i] = segments_of_labels(labels[i], options.min_size);
  return sweep;
}

}  // namespace symscene
