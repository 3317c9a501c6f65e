#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/options.hpp"

namespace symscene {

enum class Sensor : std::uint8_t {
  structured_light,  ///< Kinect v1, Xtion
  stereo,            ///< active stereo: RealSense D400
  time_of_flight     ///< Kinect v2
};

/// "structured-light", "stereo" or "tof".
const char* to_string(Sensor sensor);

/// The sensor of that name. Throws InputError for any other text.
Sensor parse_sensor(const std::string& name);

/// How the sensor is identified from the residuals of smooth patches.
struct SensorEstimationOptions {
  int frames = 5;
  int patch = 16;
  double min_filled = 0.33;
  double max_relative_deviation = 0.1;
  double depth_bin = 0.2;
  double smooth_share = 0.3;
  int min_patches = 20;
  double min_depth_ratio = 1.3;
  double max_constant_exponent = 0.8;
  double min_quadratic_exponent = 1.3;
  double max_independent = 0.2;
  double min_stereo_correlation = 0.7;
  double min_deviation = 4e-4;
  double stereo_disparity = 0.08;
  double stereo_baseline = 0.05;
  double time_of_flight_deviation = 1.3e-3;
  double flying_step = 0.015;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("frames", self.frames, "", between(1, 100), "frames that are looked at");
    visit("patch", self.patch, "px", between(6, 64), "edge of a patch to which a plane is fitted");
    visit("min_filled", self.min_filled, "", between(0.0, 1.0),
          "share of a patch's pixels that must be measured");
    visit("max_relative_deviation", self.max_relative_deviation, "", above(0.0),
          "deviation over depth up to which a patch may be a smooth surface");
    visit(
        "depth_bin", self.depth_bin, "", above(0.0),
        "width of an interval of depths whose patches are compared, in the logarithm of the depth");
    visit("smooth_share", self.smooth_share, "", above_up_to(0.0, 1.0),
          "share of the patches at one depth that are taken for smooth: those of least residual");
    visit("min_patches", self.min_patches, "", at_least(5.0), "least patches at one depth");
    visit("min_depth_ratio", self.min_depth_ratio, "", at_least(1.1),
          "least ratio of two depths whose noise is compared");
    visit("max_constant_exponent", self.max_constant_exponent, "", at_least(0.0),
          "power of the depth up to which the deviation counts as constant: time of flight");
    visit("min_quadratic_exponent", self.min_quadratic_exponent, "", at_least(0.0),
          "power of the depth from which the deviation counts as quadratic: triangulation "
          "(Khoshelham and Elberink 2012, Eq. 10)");
    visit("max_independent", self.max_independent, "", between(0.0, 1.0),
          "correlation of neighbouring pixels up to which a time-of-flight camera explains it");
    visit("min_stereo_correlation", self.min_stereo_correlation, "", between(0.0, 1.0),
          "correlation of neighbouring pixels from which triangulation is stereo");
    visit("min_deviation", self.min_deviation, "m", at_least(0.0),
          "deviation up to which depths count as having no noise but that of rounding");
    visit("stereo_disparity", self.stereo_disparity, "px", above(0.0),
          "standard deviation of a disparity of a stereo camera (Grunnet-Jepsen et al. 2018)");
    visit("stereo_baseline", self.stereo_baseline, "m", above(0.0),
          "distance between the cameras of a stereo camera (D435)");
    visit("time_of_flight_deviation", self.time_of_flight_deviation, "m", above(0.0),
          "standard deviation of a depth of a time-of-flight camera (Fankhauser et al. 2015)");
    visit("flying_step", self.flying_step, "m", above(0.0),
          "step on both sides of a flying pixel of a time-of-flight camera, at 1 m; grows with "
          "depth");
  }
  /// Throws InputError if a value is out of its range or constant and quadratic growth overlap.
  void validate() const;
};

/// The noise of smooth patches at one depth.
struct DepthNoiseSample {
  double depth = 0.0;         ///< [m]
  double deviation = 0.0;     ///< without that of rounding [m]
  std::uint32_t patches = 0;  ///< at that depth
};

/// The noise of depth frames, and the sensor that explains it.
struct SensorEstimate {
  std::optional<Sensor> sensor;           ///< none if no model explains the noise
  std::vector<DepthNoiseSample> samples;  ///< by ascending depth, where noise exceeds rounding
  double step = 0.0;                      ///< in which the depths are stored [m]
  std::uint32_t rounded = 0;              ///< depths at which rounding is most of the noise
  double exponent = 0.0;                  ///< of the depth in the deviation
  double deviation_at_1m = 0.0;           ///< of the power law [m]
  double correlation = 0.0;               ///< of neighbouring pixels
  std::string reason;                     ///< why no sensor is named
  bool too_little = false;                ///< to compare: too few smooth patches or depths
};

/// Fits planes to patches of the frames and compares the residuals of smooth ones with the models
/// of the sensors: triangulation has σ ~ z², in stereo correlated over the windows that are
/// matched; time of flight has a constant σ, independent from pixel to pixel. The variance of
/// rounding to the step in which depths are stored, step² / 12, is subtracted: near the camera it
/// would make any noise constant. Throws InputError if a frame is not of the camera's size.
SensorEstimate estimate_sensor(std::span<const DepthFrame> frames, const CameraIntrinsics& camera,
                               const SensorEstimationOptions& options = {});

/// The standard deviation of a depth over its square, around `depth` [m]. That of a time-of-flight
/// camera is not below that of structured light: multipath leaves errors beyond its noise. [1/m]
double depth_noise(Sensor sensor, const CameraIntrinsics& camera, double depth,
                   const SensorEstimationOptions& options = {});

/// The frame without pixels between two surfaces: whose neighbours on opposite sides are nearer and
/// farther by `step` [m] at 1 m (Sarbolandi et al. 2015, section 5.8).
DepthFrame without_flying_pixels(DepthFrame frame, const CameraIntrinsics& camera, double step);

}  // namespace symscene
