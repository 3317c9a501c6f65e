#pragma once

#include "symscene/core/options.hpp"
#include "symscene/simulation/cloud_fusion.hpp"

namespace symscene {

struct OccupancyFusionOptions {
  double resolution = 0.005;
  double free_margin = 0.006;
  int min_free_frames = 2;
  int min_hit_frames = 2;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("resolution", self.resolution, "m", above(0.0), "edge of a voxel (section 2.1.2)");
    visit("free_margin", self.free_margin, "m", above(0.0),
          "distance in front of the measured depth from which space counts as free: half the "
          "diagonal of a voxel and the noise of the depth");
    visit("min_free_frames", self.min_free_frames, "", at_least(1),
          "frames that must have looked through a free voxel");
    visit("min_hit_frames", self.min_hit_frames, "", at_least(1),
          "frames that must have measured a point in an occupied voxel");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
