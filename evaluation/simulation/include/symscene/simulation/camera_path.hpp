#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/camera.hpp"
#include "symscene/core/options.hpp"

namespace symscene {

/// How the camera goes around the table: the arc of section 2.2.
struct CameraArcOptions {
  int frames = 20;                   ///< along the arc; at most 64 are fused in memory
  double arc = 2.0943951;            ///< horizontal angle of the arc, 120° [rad]
  double radius = 1.0;               ///< distance to the point looked at [m]
  double min_elevation = 0.6108652;  ///< lowest above the table, 35° [rad]
  double max_elevation = 0.8726646;  ///< highest above the table, 50° [rad]
  double target_height = 0.06;       ///< of the point looked at, over the table [m]
  int width = 640;                   ///< [px]
  int height = 480;                  ///< [px]
  double focal_length = 525.0;       ///< [px]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("frames", self.frames, "", "frames along the arc");
    visit("arc", self.arc, "rad", "horizontal angle of the arc");
    visit("radius", self.radius, "m", "distance to the point looked at");
    visit("min_elevation", self.min_elevation, "rad", "lowest elevation above the table");
    visit("max_elevation", self.max_elevation, "rad", "highest elevation above the table");
    visit("target_height", self.target_height, "m", "height of the point looked at");
    visit("width", self.width, "px", "width of the images");
    visit("height", self.height, "px", "height of the images");
    visit("focal_length", self.focal_length, "px", "focal length");
  }
  void validate() const;

  CameraIntrinsics intrinsics() const;
};

/// The poses along the arc, one a frame: on its way the camera rises from its lowest to its highest
/// elevation and comes back. Table frame.
std::vector<Eigen::Isometry3d> camera_arc(const CameraArcOptions& options);

/// How a hand that holds a camera moves it beside the way that it means to go.
struct HandShakeOptions {
  double translation = 0.005;   ///< standard deviation along each axis [m]
  double rotation = 0.0087266;  ///< standard deviation about each axis, 0.5° [rad]
  double min_frequency = 0.5;   ///< slowest part [Hz]
  double max_frequency = 2.5;   ///< fastest part [Hz]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("translation", self.translation, "m", "standard deviation along each axis");
    visit("rotation", self.rotation, "rad", "standard deviation about each axis");
    visit("min_frequency", self.min_frequency, "Hz", "slowest part");
    visit("max_frequency", self.max_frequency, "Hz", "fastest part");
  }
  void validate() const;
};

/// `path`, `frame_rate` poses a second, as a hand would go along it: smooth noise, band-limited and
/// bounded by four standard deviations, in the camera's frame.
std::vector<Eigen::Isometry3d> shaken(std::vector<Eigen::Isometry3d> path, double frame_rate,
                                      const HandShakeOptions& options, std::uint64_t seed);

}  // namespace symscene
