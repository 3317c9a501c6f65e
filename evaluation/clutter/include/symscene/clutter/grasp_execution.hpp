#pragma once

#include <cstddef>
#include <optional>

#include <Eigen/Geometry>

#include "symscene/core/grasp.hpp"
#include "symscene/physics/grasp_world.hpp"

namespace symscene {

/// How the hand executes a grasp (VGN, Breyer et al., "Volumetric Grasping Network", CoRL 2020).
struct GraspExecutionOptions {
  double approach = 0.05;
  double step = 0.002;
  double speed = 0.1;
  double closing_time = 0.5;
  double retreat = 0.1;
  double steep_angle = backwards_tilt;
  double min_width = 0.008;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("approach", self.approach, "m", above(0.0), "length of the approach");
    visit("step", self.step, "m", above(0.0), "distance after which contacts are looked for");
    visit("speed", self.speed, "m/s", above(0.0), "speed of the hand");
    visit("closing_time", self.closing_time, "s", above(0.0), "time in which the fingers close");
    visit("retreat", self.retreat, "m", above(0.0), "length of the retreat");
    visit("steep_angle", self.steep_angle, "rad", between(0.0, radians(180.0)),
          "approaches within this angle of straight down retreat along themselves, others upwards");
    visit("min_width", self.min_width, "m", at_least(0.0),
          "a hand that is closed to this width at the end holds nothing");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// How the execution of a grasp ended.
enum class GraspEnd {
  success,
  contact_at_start,         ///< the open hand touches something before its approach
  nothing_between_fingers,  ///< after closing, no body touches both fingers or they are too close
  slipped,                  ///< a body between the fingers was lost in the retreat
  diverged                  ///< the physics diverged; execute_grasp throws instead
};

const char* to_string(GraspEnd end);

/// What the approach touched first.
enum class ApproachContact { none, table, body };

const char* to_string(ApproachContact contact);

struct GraspOutcome {
  GraspEnd end = GraspEnd::contact_at_start;
  ApproachContact contact = ApproachContact::none;  ///< at which the approach, or the start, ended
  double short_by = 0.0;      ///< distance from the grasp at which the approach ended [m]
  double closed_width = 0.0;  ///< after closing [m]
  double width = 0.0;         ///< at the end [m]
  std::optional<std::size_t> body = {};  ///< held at the end, or touched where nothing is held
};

/// Executes a grasp: the open hand starts before it, moves straight to it until it touches
/// anything, closes and retreats. It succeeds if the hand touches a body at the end and is not
/// closed. The hand stays in the world.
GraspOutcome execute_grasp(GraspWorld& world, const Eigen::Isometry3d& T_table_tool,
                           const GraspExecutionOptions& options = {});

}  // namespace symscene
