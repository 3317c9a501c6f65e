#pragma once

#include <cstdint>
#include <string>

#include "symscene/dataset/swept_scene.hpp"

namespace symscene {

/// What differs between the scenes of a dataset that covers many cameras and rooms. Each scene
/// draws its values from its own seed; scene.json records them.
struct SceneVariationOptions {
  bool enabled = false;
  double stereo = 0.35;
  double tof = 0.25;
  double min_noise = 0.5;
  double max_noise = 1.25;
  bool cameras = true;
  double missing_lines = 0.15;
  double min_distance = 0.4;
  double max_distance = 2.5;
  double clearance = 0.2;
  double min_elevation = 0.25;
  double max_elevation = 1.5;
  double single_views = 0.4;
  double few_views = 0.3;
  int min_few_frames = 2;
  int max_few_frames = 15;
  int min_tracked_frames = 30;
  int max_tracked_frames = 200;
  double tracked_step = 0.02;
  double small_tables = 0.4;
  double endless_tables = 0.2;
  double rooms = 0.6;
  double no_occupancy = 0.1;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("enabled", self.enabled, "", any_value(),
          "draw sensor, camera, views and table of each scene; otherwise all scenes have the same");
    visit("stereo", self.stereo, "", between(0.0, 1.0), "share of scenes of active stereo cameras");
    visit("tof", self.tof, "", between(0.0, 1.0),
          "share of scenes of time-of-flight cameras; the rest is structured light");
    visit("min_noise", self.min_noise, "", above(0.0),
          "least factor of the sensor's deviation, drawn uniformly in its logarithm");
    visit("max_noise", self.max_noise, "", above(0.0), "greatest factor of the sensor's deviation");
    visit("cameras", self.cameras, "", any_value(),
          "draw image size and focal length among those of common cameras");
    visit("missing_lines", self.missing_lines, "", between(0.0, 1.0),
          "share of scenes whose depth was registered to colour, with rows and columns missing");
    visit("min_distance", self.min_distance, "m", above(0.0),
          "least distance of the camera, drawn uniformly in its logarithm");
    visit("max_distance", self.max_distance, "m", above(0.0), "greatest distance of the camera");
    visit("clearance", self.clearance, "m", at_least(0.0),
          "least distance of the camera from the ball around the objects");
    visit("min_elevation", self.min_elevation, "rad", above(0.0), "least elevation of the camera");
    visit("max_elevation", self.max_elevation, "rad", strictly_between(0.0, radians(89.0)),
          "greatest elevation of the camera");
    visit("single_views", self.single_views, "", between(0.0, 1.0), "share of scenes of one frame");
    visit("few_views", self.few_views, "", between(0.0, 1.0),
          "share of scenes of few frames with exact poses, spread over the arc");
    visit("min_few_frames", self.min_few_frames, "", at_least(2),
          "fewest frames of a scene of few");
    visit("max_few_frames", self.max_few_frames, "", at_least(2),
          "most frames of a scene of few, drawn uniformly in its logarithm");
    visit("min_tracked_frames", self.min_tracked_frames, "", at_least(2),
          "fewest frames of a scene whose poses are tracked");
    visit("max_tracked_frames", self.max_tracked_frames, "", at_least(2),
          "most frames of a scene whose poses are tracked");
    visit(
        "tracked_step", self.tracked_step, "rad", above(0.0),
        "largest angle about the table between tracked frames: few of them cover less of the arc");
    visit("small_tables", self.small_tables, "", between(0.0, 1.0),
          "share of tables that end near the objects");
    visit("endless_tables", self.endless_tables, "", between(0.0, 1.0),
          "share of tables without a border in view");
    visit("rooms", self.rooms, "", between(0.0, 1.0), "share of tables on a floor before a wall");
    visit("no_occupancy", self.no_occupancy, "", between(0.0, 1.0),
          "share of scenes that are written without an occupancy map");
  }
  /// Throws InputError if a value is out of its range, a maximum is below its minimum, or shares
  /// add up to more than one.
  void validate() const;
};

/// How a scene is made.
struct ScenePlan {
  SweepOptions sweep;
  SweptSceneOptions making;
  double noise = 1.0;  ///< factor of the sensor's deviation
  bool with_occupancy = true;
};

}  // namespace symscene
