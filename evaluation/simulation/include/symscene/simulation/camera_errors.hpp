#pragma once

#include "symscene/core/camera_model.hpp"
#include "symscene/core/options.hpp"

namespace symscene {

/// Systematic errors of a depth camera, which calibration removes. Those of real cameras: depths
/// of structured light are off by 1 to 3 % at 2 m, smoothly over the image and growing with range
/// (Teichman et al. 2013, section II).
struct CameraErrorOptions {
  double k1 = 0.0;
  double k2 = 0.0;
  double p1 = 0.0;
  double p2 = 0.0;
  double k3 = 0.0;
  double depth_bias = 0.0;
  std::uint64_t bias_pattern = 1;
  double color_offset = 0.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("k1", self.k1, "", between(-1.0, 1.0), "radial distortion of r^2 (Brown 1971)");
    visit("k2", self.k2, "", between(-1.0, 1.0), "radial distortion of r^4");
    visit("p1", self.p1, "", between(-0.1, 0.1), "tangential distortion along y");
    visit("p2", self.p2, "", between(-0.1, 0.1), "tangential distortion along x");
    visit("k3", self.k3, "", between(-1.0, 1.0), "radial distortion of r^6");
    visit("depth_bias", self.depth_bias, "", between(0.0, 0.1),
          "greatest share by which depth is off at 2 m; it grows linearly with range and varies "
          "smoothly over the image (Teichman et al. 2013)");
    visit("bias_pattern", self.bias_pattern, "", any_value(),
          "seed of how the depth error varies over the image");
    visit("color_offset", self.color_offset, "m", between(-0.2, 0.2),
          "distance of the colour camera to the right of the depth camera; colours are then not "
          "registered to the depth");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }

  LensDistortion lens() const { return {k1, k2, p1, p2, k3}; }
};

/// The error of the depth of a camera.
class DepthBias {
 public:
  DepthBias(const CameraErrorOptions& options, const CameraIntrinsics& camera);

  /// Measured over true depth at a pixel of the undistorted image and a true depth. [px, m]
  double factor(double u, double v, double depth) const;

 private:
  static constexpr int waves = 4;
  CameraIntrinsics camera_;
  double at_2m_;
  /// Amplitude, waves per half image along x and y, phase.
  Eigen::Matrix<double, 4, waves> waves_;
};

}  // namespace symscene
