#pragma once

#include "core/random.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/types.hpp"
#include "symscene/simulation/sensor_frame.hpp"

namespace symscene {

/// The errors of a structured-light depth camera (Kinect, Xtion).
///
/// - Axial noise grows with the square of the depth, σ_z = axial · z²: Khoshelham and Elberink,
///   "Accuracy and resolution of Kinect depth data for indoor mapping applications", Sensors 12(2),
///   2012, Eq. 10, have 1.43e-3 1/m; Nguyen, Izadi and Lovell, "Modeling Kinect sensor noise for
///   improved 3D reconstruction and tracking", 3DIMPVT 2012, measure 1.2 mm at the near end. The
///   sensor correlates windows of pixels, so neighbours err alike: noise is drawn on a coarse grid
///   and interpolated.
/// - The sensor measures disparity in steps: depths are z with 1/z a multiple of 2.85e-3 1/m
///   (Khoshelham and Elberink, Eq. 12: 2.8 mm apart at 1 m).
/// - Lateral noise shifts where a pixel looks (Nguyen et al.: 0.8 px at all but grazing angles,
///   which covers steps of the correlation window; half of it frays edges as seen in real images).
/// - No measurement beyond a grazing angle (Nguyen et al.: unreliable from 70°, none over 80°), nor
///   for a share of the pixels at depth edges, where the pattern is in shadow.
struct SensorNoiseOptions {
  bool enabled = true;               ///< off: exact depth
  double axial = 1.2e-3;             ///< standard deviation over squared depth [1/m]
  double grain = 2.0;                ///< spacing of the grid on which noise is drawn [px]
  double disparity_step = 2.85e-3;   ///< step of 1/z, 0 for none [1/m]
  double lateral = 0.4;              ///< standard deviation of a pixel's place [px]
  double grazing_begin = 1.2217305;  ///< angle from which pixels begin to drop out, 70° [rad]
  double grazing_end = 1.4486233;    ///< angle from which no pixel is measured, 83° [rad]
  double edge_step = 0.03;           ///< depth between neighbours that makes an edge [m]
  double edge_dropout = 0.4;         ///< share of the pixels at edges that is lost
  double max_depth = 4.0;            ///< range of the sensor [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("enabled", self.enabled, "", "add sensor noise");
    visit("axial", self.axial, "1/m", "standard deviation of depth over its square");
    visit("grain", self.grain, "px", "spacing of the grid on which noise is drawn");
    visit("disparity_step", self.disparity_step, "1/m", "step of inverse depth, 0 for none");
    visit("lateral", self.lateral, "px", "standard deviation of a pixel's place");
    visit("grazing_begin", self.grazing_begin, "rad", "angle from which pixels begin to drop out");
    visit("grazing_end", self.grazing_end, "rad", "angle from which no pixel is measured");
    visit("edge_step", self.edge_step, "m", "depth between neighbours that makes an edge");
    visit("edge_dropout", self.edge_dropout, "", "share of the pixels at edges that is lost");
    visit("max_depth", self.max_depth, "m", "range of the sensor");
  }
  void validate() const;
};

/// What the sensor would have measured of an exact frame.
SensorFrame add_sensor_noise(const SensorFrame& exact, const CameraIntrinsics& camera,
                             const SensorNoiseOptions& options, Random random);

}  // namespace symscene
