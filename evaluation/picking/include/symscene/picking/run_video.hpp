#pragma once

#include <string>

#include "symscene/core/options.hpp"
#include "symscene/viewer/run_page.hpp"

namespace symscene {

/// How a video of a run is made.
struct RunVideoOptions {
  int width = 480;
  int height = 360;
  double frame_rate = 10.0;
  double max_duration = 30.0;
  double last_frame = 2.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("width", self.width, "px", between(16, 4096), "width of the images");
    visit("height", self.height, "px", between(16, 4096), "height of the images");
    visit("frame_rate", self.frame_rate, "1/s", between(1.0, 50.0), "images per second");
    visit("max_duration", self.max_duration, "s", between(1.0, 600.0),
          "longer runs are played faster, to last so long");
    visit("last_frame", self.last_frame, "s", between(0.0, 60.0),
          "how much longer the last image is shown, before the video begins again");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// A run as an animated GIF: the true scene, that is the robot, the objects, the table and the bin,
/// from a fixed camera that sees all of the robot's motion. Each solid has one colour. The bytes
/// are the same for any number of threads. Throws InputError if an option is out of its range, the
/// recording has no moments or cannot be drawn (render_run_page()), or this build has no giflib.
std::string render_run_video(const RunRecording& recording, const RunVideoOptions& options = {});

}  // namespace symscene
