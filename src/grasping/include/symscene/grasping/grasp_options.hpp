#pragma once

#include "symscene/core/options.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"

namespace symscene {

struct GraspOptions {
  double space_margin = 0.25;
  int max_voxels = default_max_voxels;
  int surface_points = 120;
  int approaches = 12;
  int max_grasps = 20;
  double min_quality = 0.1;
  double table_clearance = 0.002;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("space_margin", self.space_margin, "m", between(0.0, 10.0),
          "margin around the objects within which free space is read");
    visit("max_voxels", self.max_voxels, "", between(4096.0, 1 << 30),
          "voxels of that space; a larger one gets coarser voxels");
    visit("surface_points", self.surface_points, "", between(1.0, 1e5),
          "points of the closed surface at which antipodal grasps start");
    visit("approaches", self.approaches, "", between(1.0, 360.0),
          "directions of approach about a line between two contacts");
    visit("max_grasps", self.max_grasps, "", between(1.0, 1e5), "most grasps per object");
    visit("min_quality", self.min_quality, "", between(0.0, 1.0),
          "grasps of lower quality are rejected");
    visit("table_clearance", self.table_clearance, "m", between(0.0, 0.1),
          "least distance of the gripper from the table");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
