#pragma once

#include "reconstruction/measurement.hpp"
#include "reconstruction/model_view.hpp"
#include "symscene/reconstruction/reconstruction.hpp"

namespace symscene {

/// Whether a measurement shows enough surface to be tracked or to start a model.
bool measures_enough(const Measurement& measurement, const TrackingOptions& options);

/// Point-to-plane alignment of a measurement with a view of the model, from coarse to fine, with
/// projective data association (Newcombe et al. 2011, Eqs. 16 to 24). Along unconstrained motions
/// the camera stays at `T_world_guess` (Zhang and Singh 2016). Lost, with the reason, if too little
/// is measured, matched or agrees, or if the camera would be too far from the view's pose.
TrackingResult track_camera(const Measurement& measurement, const ModelView& view,
                            const Eigen::Isometry3d& T_world_guess, const TrackingOptions& options,
                            const MeasurementOptions& sensor);

/// The same with a guess that is itself a measurement of the pose, with `prior_deviation`: it takes
/// part in the alignment as the image does. Lost also if the image asks for more than three of
/// these deviations.
TrackingResult track_camera_with_prior(const Measurement& measurement, const ModelView& view,
                                       const Eigen::Isometry3d& T_world_prior,
                                       const TrackingOptions& options,
                                       const MeasurementOptions& sensor);

}  // namespace symscene
