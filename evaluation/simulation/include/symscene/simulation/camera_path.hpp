#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/camera.hpp"
#include "symscene/core/options.hpp"

namespace symscene {

/// The path of the camera around the table: the arc of section 2.2.
struct CameraArcOptions {
  int frames = 20;
  double arc = radians(120.0);
  double radius = 1.0;
  double min_elevation = radians(35.0);
  double max_elevation = radians(50.0);
  double target_height = 0.06;
  int width = 640;
  int height = 480;
  double focal_length = 525.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("frames", self.frames, "", between(1, 100000),
          "frames along the arc; fusion with known poses takes at most 64");
    visit("arc", self.arc, "rad", at_least(0.0), "horizontal angle of the arc (section 2.2)");
    visit("radius", self.radius, "m", above(0.0), "distance to the point looked at");
    visit("min_elevation", self.min_elevation, "rad", above(0.0),
          "lowest elevation of the camera above the table, at both ends of the arc");
    visit("max_elevation", self.max_elevation, "rad", strictly_between(0.0, radians(89.0)),
          "highest elevation of the camera above the table, in the middle of the arc");
    visit("target_height", self.target_height, "m", any_value(),
          "height of the point looked at above the table");
    visit("width", self.width, "px", at_least(16), "width of the images");
    visit("height", self.height, "px", at_least(16), "height of the images");
    visit("focal_length", self.focal_length, "px", above(0.0), "focal length of both axes");
  }
  /// Throws InputError if a value is out of its range or max_elevation is below min_elevation.
  void validate() const;

  CameraIntrinsics intrinsics() const;
};

/// The poses T_table_camera along the arc, one per frame. Along the way the camera rises from its
/// lowest to its highest elevation and comes back. Throws InputError if an option is out of range.
std::vector<Eigen::Isometry3d> camera_arc(const CameraArcOptions& options);

/// Deviation of a hand-held camera from its intended path.
struct HandShakeOptions {
  double translation = 0.005;
  double rotation = radians(0.5);
  double min_frequency = 0.5;
  double max_frequency = 2.5;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("translation", self.translation, "m", at_least(0.0),
          "standard deviation of the position along each axis of the camera");
    visit("rotation", self.rotation, "rad", at_least(0.0),
          "standard deviation of the rotation about each axis of the camera");
    visit("min_frequency", self.min_frequency, "Hz", above(0.0), "lowest frequency of the shake");
    visit("max_frequency", self.max_frequency, "Hz", above(0.0), "highest frequency of the shake");
  }
  /// Throws InputError if a value is out of its range or max_frequency is below min_frequency.
  void validate() const;
};

}  // namespace symscene
