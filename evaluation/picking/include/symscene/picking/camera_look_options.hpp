#pragma once

#include "symscene/core/camera.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// The motion of a camera on an arm past a table, and its images.
struct CameraLookOptions {
  int frames = 20;
  int stations = 9;
  int max_views = 6;
  double arc = radians(140.0);
  double min_elevation = radians(35.0);
  double max_elevation = radians(75.0);
  double min_radius = 0.4;
  double max_radius = 0.7;
  double target_height = 0.04;
  double speed = 0.3;
  double keep_out_radius = 0.3;
  double keep_out_height = 0.3;
  double max_robot_share = 0.5;
  double pose_deviation = 0.001;
  double rotation_deviation = radians(0.1);
  int width = 640;
  int height = 480;
  double focal_length = 420.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("frames", self.frames, "", between(1, 100000), "images of a look along a sweep");
    visit("stations", self.stations, "", between(2, 1000),
          "directions about the table's middle from which the arm tries to look");
    visit("max_views", self.max_views, "", between(1, 1000),
          "greatest number of images of a look whose views are chosen one by one");
    visit("arc", self.arc, "rad", between(0.0, radians(360.0)),
          "horizontal angle that these directions span, symmetric about that to the robot");
    visit("min_elevation", self.min_elevation, "rad", above_up_to(0.0, radians(89.0)),
          "lowest elevation of the camera above the table");
    visit("max_elevation", self.max_elevation, "rad", above_up_to(0.0, radians(89.0)),
          "highest elevation of the camera above the table");
    visit("min_radius", self.min_radius, "m", above_up_to(0.0, 10.0),
          "least distance of the camera from the point looked at");
    visit("max_radius", self.max_radius, "m", above_up_to(0.0, 10.0),
          "greatest distance, which is tried first: it shows most of the table");
    visit("target_height", self.target_height, "m", between(-2.0, 2.0),
          "height of the point looked at above the table's middle");
    visit("speed", self.speed, "m/s", above_up_to(0.0, 10.0), "mean speed of the camera");
    visit("keep_out_radius", self.keep_out_radius, "m", between(0.0, 2.0),
          "the arm stays out of a cylinder of this radius about the table's middle while it looks: "
          "it does not know yet what stands there");
    visit("keep_out_height", self.keep_out_height, "m", between(0.0, 2.0),
          "height of that cylinder");
    visit("max_robot_share", self.max_robot_share, "", between(0.0, 1.0),
          "greatest share of the images that the robot itself may cover before the run says so");
    visit("pose_deviation", self.pose_deviation, "m", between(0.0, 0.1),
          "standard deviation of the camera's position by the arm's joints, for each image anew");
    visit("rotation_deviation", self.rotation_deviation, "rad", between(0.0, radians(10.0)),
          "standard deviation of the camera's orientation by the arm's joints, about each axis");
    visit("width", self.width, "px", between(16, 4096), "width of the images");
    visit("height", self.height, "px", between(16, 4096), "height of the images");
    visit("focal_length", self.focal_length, "px", between(1.0, 1e5), "focal length of both axes");
  }
  /// Throws InputError if a value is out of its range, or a least value exceeds its greatest.
  void validate() const;

  CameraIntrinsics intrinsics() const;
};

}  // namespace symscene
