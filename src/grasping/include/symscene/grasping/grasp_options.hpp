#pragma once

#include <numbers>

#include "symscene/core/options.hpp"
#include "symscene/core/types.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"

namespace symscene {

/// Which candidates are made.
struct GraspCandidateOptions {
  double line_spacing = 0.02;
  double max_lever_arm = 0.05;
  int axis_angles = 8;
  double rim_depth = 0.02;
  double rim_window = 0.01;
  double max_wall = 0.015;
  int surface_points = 100;
  double approach_step = radians(20.0);
  double max_tilt = radians(100.0);
  double shallow_overhang = 0.01;
  double deep_overhang = 0.03;
  double min_overhang = 0.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("line_spacing", self.line_spacing, "m", between(1e-3, 1.0),
          "spacing of the lines across an axis, a mirror plane or a face of a box");
    visit("max_lever_arm", self.max_lever_arm, "m", at_least(0.0),
          "greatest distance of lines across a plane from the centre of mass");
    visit("axis_angles", self.axis_angles, "", between(1, 180),
          "angles within half a turn about an axis; of the wall of a vessel twice as many");
    visit("rim_depth", self.rim_depth, "m", above_up_to(0.0, 0.5),
          "how far below the rim the wall of a vessel is searched; it is grasped at half of this");
    visit("rim_window", self.rim_window, "m", above_up_to(0.0, 0.1),
          "half the extent along the rim within which a wall is searched");
    visit("max_wall", self.max_wall, "m", above_up_to(0.0, 0.5),
          "thickest wall that is grasped at the rim");
    visit("surface_points", self.surface_points, "", between(0, 100000),
          "points of the closed surface at which antipodal grasps start");
    visit("approach_step", self.approach_step, "rad", between(0.01, std::numbers::pi),
          "angle between directions of approach to a line");
    visit("max_tilt", self.max_tilt, "rad", between(0.0, std::numbers::pi),
          "greatest angle between the direction of approach and straight down");
    visit("shallow_overhang", self.shallow_overhang, "m", between(0.0, 0.5),
          "how far the finger tips reach beyond the line of a shallow grasp");
    visit("deep_overhang", self.deep_overhang, "m", between(0.0, 0.5),
          "the same of a deep grasp; less where the table is in the way");
    visit("min_overhang", self.min_overhang, "m", between(0.0, 0.5),
          "least distance by which the tips reach beyond the line");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// When candidates are rejected.
struct GraspBoundOptions {
  double opening_clearance = 0.004;
  double contact_give = 0.002;
  double min_contact_area = 0.05;
  double density = 500.0;
  double max_weight_ratio = 1.0;
  double max_torque_ratio = 3.0;
  double table_clearance = 0.002;
  double object_clearance = 0.002;
  double own_clearance = 0.001;
  double own_reach = 0.05;
  double max_unknown = 0.02;
  double min_quality = 0.6;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("opening_clearance", self.opening_clearance, "m", at_least(0.0),
          "an object is at least this much narrower than the gripper opens");
    visit("contact_give", self.contact_give, "m", at_least(0.0),
          "pads touch what lies up to this far behind the first contact");
    visit("min_contact_area", self.min_contact_area, "", between(0.0, 1.0),
          "least touched area of a pad, relative to the square of the finger's width");
    visit("density", self.density, "kg/m3", at_least(0.0),
          "assumed mean density of objects, for their weight");
    visit("max_weight_ratio", self.max_weight_ratio, "", at_least(0.0),
          "greatest part of the weight along the pads, relative to what their friction holds");
    visit(
        "max_torque_ratio", self.max_torque_ratio, "", at_least(0.0),
        "greatest torque of the weight about the closing direction, relative to what the friction "
        "of the pads holds; above 1, as most objects are hollow and so lighter than assumed");
    visit("table_clearance", self.table_clearance, "m", at_least(0.0),
          "least distance of the gripper from the table");
    visit("object_clearance", self.object_clearance, "m", any_value(),
          "least distance of the gripper from other objects");
    visit("own_clearance", self.own_clearance, "m", any_value(),
          "least distance of the open gripper from the object itself");
    visit("own_reach", self.own_reach, "m", between(0.0, 1.0),
          "space that was not seen is no obstacle within this distance of the object, if no other "
          "object is nearer: its closed surface says what is there");
    visit("max_unknown", self.max_unknown, "", between(0.0, 1.0),
          "greatest share of the fingers, and of the palm, on their way in other space that was "
          "never "
          "seen, which allows for the size of voxels; 1 counts such space as free");
    visit("min_quality", self.min_quality, "", between(0.0, 1.0),
          "grasps of lower quality are rejected");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

struct GraspOptions {
  double space_margin = 0.25;
  int max_voxels = default_max_voxels;
  int max_grasps = 20;
  int max_rejected = 20;
  double distinct_distance = 0.015;
  double distinct_angle = radians(25.0);
  GraspCandidateOptions candidates;
  GraspBoundOptions bounds;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("space_margin", self.space_margin, "m", between(0.0, 10.0),
          "margin around the objects within which free space is read; the hand needs it");
    visit("max_voxels", self.max_voxels, "", between(4096.0, 1 << 30),
          "voxels of that space; a larger one gets coarser voxels");
    visit("max_grasps", self.max_grasps, "", between(1.0, 1e5), "most grasps per object");
    visit("max_rejected", self.max_rejected, "", between(0, 100000),
          "most rejected candidates that an object keeps for each reason; all are counted");
    visit("distinct_distance", self.distinct_distance, "m", at_least(0.0),
          "a grasp is left out if a better one is nearer than this and turned by less than "
          "distinct_angle");
    visit("distinct_angle", self.distinct_angle, "rad", at_least(0.0), "see distinct_distance");
    visit("candidates", self.candidates);
    visit("bounds", self.bounds);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
