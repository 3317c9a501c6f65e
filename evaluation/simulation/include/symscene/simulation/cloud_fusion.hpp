#pragma once

#include "symscene/core/options.hpp"

namespace symscene {

struct CloudFusionOptions {
  double voxel_size = 0.003;
  int min_frames = 3;
  double edge_step = 0.015;
  int normal_radius = 3;
  double smoothing = 0.0035;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", above(0.0),
          "spacing of the fused points (3.1 mm in section 2.1.1)");
    visit("min_frames", self.min_frames, "", at_least(1), "frames that must have seen a point");
    visit("edge_step", self.edge_step, "m", above(0.0),
          "depth step between neighbouring pixels from which they count as flying pixels");
    visit("normal_radius", self.normal_radius, "px", at_least(1),
          "half width of the window in which a normal is fitted");
    visit("smoothing", self.smoothing, "m", above(0.0),
          "standard deviation of the smoothing over the surface");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
