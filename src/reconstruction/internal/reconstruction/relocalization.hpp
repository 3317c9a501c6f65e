#pragma once

#include <vector>

#include "reconstruction/measurement.hpp"
#include "reconstruction/model_view.hpp"
#include "symscene/reconstruction/reconstruction.hpp"

namespace symscene {

/// At most `relocalize_starts` poses from which to track a lost camera: `T_world_about`, then, best
/// first, the poses on a grid along the three least constrained motions at which most pixels agree
/// with the view. A table looks the same along all of it; the objects on it do not. Empty without
/// enough matches.
std::vector<Eigen::Isometry3d> likely_poses(const Measurement& measurement, const ModelView& view,
                                            const Eigen::Isometry3d& T_world_about,
                                            const TrackingOptions& options,
                                            const MeasurementOptions& sensor);

/// The pose at which a measurement agrees with the view most, tracked from each of the likely poses
/// under the bounds of a lost camera. Lost if none converges.
TrackingResult search_camera(const Measurement& measurement, const ModelView& view,
                             const Eigen::Isometry3d& T_world_about, const TrackingOptions& options,
                             const MeasurementOptions& sensor);

/// The stricter bounds of a lost camera.
TrackingOptions when_lost(TrackingOptions options);

}  // namespace symscene
