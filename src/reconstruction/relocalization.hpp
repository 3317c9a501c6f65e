#pragma once

#include <vector>

#include "reconstruction/measurement.hpp"
#include "reconstruction/model_view.hpp"
#include "symscene/reconstruction/tracking_options.hpp"

namespace symscene {

/// At most `relocalize_starts` poses from which to track a lost camera: `T_world_about`, then, best
/// first, the poses on a grid along the three least constrained motions at which most pixels agree
/// with the view. A table looks the same along all of it; the objects on it do not. Empty without
/// enough matches.
std::vector<Eigen::Isometry3d> likely_poses(const Measurement& measurement, const ModelView& view,
                                            const Eigen::Isometry3d& T_world_about,
                                            const TrackingOptions& options,
                                            const MeasurementOptions& sensor);

}  // namespace symscene
