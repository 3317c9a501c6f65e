#pragma once

#include <vector>

#include "symscene/motion/trajectory.hpp"

namespace symscene {

/// What a step along the path allows, of x = (ds/dt)² at its start and the acceleration u =
/// d²s/dt², which is constant in the step: a convex polygon that contains (0, 0).
class StepBounds {
 public:
  /// The limits of the joints on an arc from `begin` to `end`, everywhere in the step.
  void set_arc(const PathSegment& arc, double begin, double end, const MotionLimits& limits);
  /// Also: x at the end of the step lies between 0 and `most`.
  void bound_end(double most);

  /// The greatest x from which some u is allowed.
  double greatest_start() const;
  /// The greatest u at an x.
  double greatest_acceleration(double x) const;

 private:
  /// p u + c x ≤ d
  struct HalfPlane {
    double p, c, d;
  };
  /// u = offset + slope x
  struct Line {
    double offset, slope;
    double at(double x) const { return offset + slope * x; }
  };
  struct Ends;

  void add_velocity(double derivative, double amplitude, double limit, const Ends& ends);
  void add_acceleration(double first, double second, double amplitude, double limit,
                        const Ends& ends);
  /// p u + |u| · spread + c x ≤ d
  void add(double p, double spread, double c, double d);
  Line upper(double x) const;
  Line lower(double x) const;

  double step_ = 0.0;
  double most_ = 0.0;  ///< no u allows a greater x at the start: limits of velocity
  std::vector<HalfPlane> planes_;
};

}  // namespace symscene
