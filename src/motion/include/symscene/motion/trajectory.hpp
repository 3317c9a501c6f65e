#pragma once

#include <cstddef>
#include <vector>

#include "symscene/core/options.hpp"
#include "symscene/motion/joint_path.hpp"

namespace symscene {

/// The greatest speed and acceleration of each joint, all above 0. [rad/s, rad/s²; m for sliding
/// joints]
struct MotionLimits {
  Eigen::VectorXd velocity;
  Eigen::VectorXd acceleration;
};

struct TrajectoryOptions {
  double max_deviation = 0.1;
  double arc_step = 0.02;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_deviation", self.max_deviation, "rad", between(0.0, 10.0),
          "how far a rounded corner may pass its waypoint, in the space of joints; 0 stops at "
          "each (Kunz and Stilman 2012)");
    visit("arc_step", self.arc_step, "rad", between(1e-4, 0.2),
          "angle of a rounded corner over which the acceleration along the path is constant");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// A state of the joints at a time.
struct JointState {
  double time = 0.0;  ///< [s]
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  Eigen::VectorXd acceleration;
};

/// A part of a trajectory along one segment with constant acceleration along the path.
struct MotionPhase {
  std::size_t segment = 0;
  double time = 0.0;  ///< at its start [s]
  double duration = 0.0;
  double s = 0.0;      ///< arc length from the start of the segment
  double speed = 0.0;  ///< ds/dt at the start of the phase
  double acceleration = 0.0;
};

/// A path with its times. It starts and ends at rest.
class TimedPath {
 public:
  TimedPath(JointPath path, std::vector<MotionPhase> phases);

  double duration() const { return duration_; }
  /// The state at a time, which is clamped to [0, duration()]. Position and velocity are
  /// continuous; where the acceleration jumps it is that of the later side.
  JointState at(double time) const;
  const JointPath& path() const { return path_; }
  const std::vector<MotionPhase>& phases() const { return phases_; }

 private:
  JointState at_end() const;

  JointPath path_;
  std::vector<MotionPhase> phases_;
  double duration_ = 0.0;
};

/// The fastest motion along the rounded path within the limits, from rest to rest.
///
/// Path of Kunz and Stilman (RSS 2012). The speed along it comes from reachability analysis (Pham
/// and Pham, T-RO 2018) in place of their search for switching points: that search needs the kind
/// of each point and fails where two of them meet or where the phase plane has a trap, whereas the
/// sets of reachable speeds are never empty, whatever the path. Straight lines are solved exactly.
/// An arc is cut into steps of constant acceleration; the limits hold inside the steps too, by a
/// bound on the curvature of each constraint.
/// Throws InputError if limits are missing or not above 0, or waypoints are invalid (JointPath).
TimedPath time_optimal_trajectory(const std::vector<Eigen::VectorXd>& waypoints,
                                  const MotionLimits& limits,
                                  const TrajectoryOptions& options = {});

/// States at multiples of `period`, and at the end: times increase strictly, the last velocity is
/// zero. The last step is between half and one and a half periods long, unless the whole
/// trajectory is shorter. [s]
std::vector<JointState> sampled(const TimedPath& trajectory, double period);

}  // namespace symscene
