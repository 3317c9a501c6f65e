#pragma once

#include <vector>

#include "reconstruction/measurement.hpp"
#include "reconstruction/model_view.hpp"
#include "reconstruction/point_to_plane.hpp"
#include "symscene/reconstruction/tracking_options.hpp"

namespace symscene {

/// The images of the view at the sizes of the measurement's pyramid, finest first. Each level keeps
/// every second pixel.
std::vector<SurfaceImage> view_pyramid(const SurfaceImage& view, const Measurement& measurement);

/// The mean depth of the surface in an image, 1 without a surface. [m]
double mean_depth(const SurfaceImage& image);

/// Matching of a measurement with the model within `max_distance`. The noise of the model is the
/// constant `model_deviation`.
MatchOptions tracking_matches(double max_distance, const TrackingOptions& options,
                              const MeasurementOptions& sensor);

}  // namespace symscene
