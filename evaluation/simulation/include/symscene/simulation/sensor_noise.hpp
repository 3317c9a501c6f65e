#pragma once

#include "symscene/core/options.hpp"
#include "symscene/core/types.hpp"
#include "symscene/simulation/sensor_frame.hpp"
#include "symscene/simulation/stereo_noise_options.hpp"
#include "symscene/simulation/time_of_flight_noise_options.hpp"

namespace symscene {

class Random;

enum class SimulatedSensor {
  structured_light,  ///< Kinect v1, Xtion
  stereo,            ///< active stereo: RealSense D400
  time_of_flight     ///< Kinect v2
};

/// "structured-light", "stereo" or "tof".
const char* to_string(SimulatedSensor sensor);

/// The sensor of that name. Throws InputError for any other text.
SimulatedSensor parse_simulated_sensor(const std::string& text);

/// The errors of a depth camera. Those of a structured-light camera (Kinect, Xtion):
///
/// - Axial noise grows with the square of the depth, σ_z = axial · z²: Khoshelham and Elberink,
///   "Accuracy and resolution of Kinect depth data for indoor mapping applications", Sensors 12(2),
///   2012, Eq. 10, have 1.43e-3 1/m; Nguyen, Izadi and Lovell, "Modeling Kinect sensor noise for
///   improved 3D reconstruction and tracking", 3DIMPVT 2012, measure 1.2 mm at the near end. The
///   sensor correlates windows of pixels, so the errors of neighbours are correlated: noise is
///   drawn on a coarse grid and interpolated.
/// - The sensor measures disparity in steps: depths are z with 1/z a multiple of 2.85e-3 1/m
///   (Khoshelham and Elberink, Eq. 12: 2.8 mm apart at 1 m).
/// - Lateral noise shifts the ray of a pixel (Nguyen et al.: 0.8 px at all but grazing angles,
///   which covers steps of the correlation window; half of it frays edges as seen in real images).
/// - No measurement beyond a grazing angle (Nguyen et al.: unreliable from 70°, none over 80°), nor
///   for a share of the pixels at depth edges, where the pattern is in shadow.
/// Grazing angles, edge_step and max_depth hold for the other sensors too.
struct SensorNoiseOptions {
  bool enabled = true;
  std::string model = "structured-light";
  double axial = 1.2e-3;
  double grain = 2.0;
  double disparity_step = 2.85e-3;
  double lateral = 0.4;
  double grazing_begin = radians(70.0);
  double grazing_end = radians(83.0);
  double edge_step = 0.03;
  double edge_dropout = 0.4;
  double max_depth = 4.0;
  double missing_lines = 0.0;
  StereoNoiseOptions stereo;
  TimeOfFlightNoiseOptions tof;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("enabled", self.enabled, "", any_value(), "add noise; otherwise depth is exact");
    visit("model", self.model, "", any_value(),
          "sensor: structured-light, stereo (active) or tof (time of flight)");
    visit("axial", self.axial, "1/m", at_least(0.0),
          "standard deviation of the depth over its square (Khoshelham and Elberink 2012, Eq. 10)");
    visit("grain", self.grain, "px", at_least(1.0), "spacing of the grid on which noise is drawn");
    visit("disparity_step", self.disparity_step, "1/m", at_least(0.0),
          "step of the inverse depth, 0 for none (Khoshelham and Elberink 2012, Eq. 12)");
    visit("lateral", self.lateral, "px", at_least(0.0),
          "standard deviation of the position of a pixel (Nguyen et al. 2012)");
    visit("grazing_begin", self.grazing_begin, "rad", any_value(),
          "angle of incidence from which pixels begin to drop out (Nguyen et al. 2012)");
    visit("grazing_end", self.grazing_end, "rad", any_value(),
          "angle of incidence from which no pixel is measured (Nguyen et al. 2012)");
    visit("edge_step", self.edge_step, "m", above(0.0),
          "depth step between neighbouring pixels that makes an edge");
    visit("edge_dropout", self.edge_dropout, "", between(0.0, 1.0),
          "share of the pixels at edges that is not measured");
    visit("max_depth", self.max_depth, "m", above(0.0), "range of the sensor");
    visit("missing_lines", self.missing_lines, "px", at_least(0.0),
          "interval of rows and columns without depth, as where a depth image was registered to a "
          "larger colour image; 0 for none");
    visit("stereo", self.stereo);
    visit("tof", self.tof);
  }
  /// Throws InputError if a value is out of its range, the model is not known, or grazing_end is
  /// not above grazing_begin.
  void validate() const;
};

/// Adds the noise of the sensor to the noise-free frame `exact`. Throws InputError if an option is
/// out of range.
SensorFrame add_sensor_noise(const SensorFrame& exact, const CameraIntrinsics& camera,
                             const SensorNoiseOptions& options, Random random);

}  // namespace symscene
