#pragma once

#include <vector>

#include <Eigen/Core>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Remembers where attempts failed, by the points between the finger tips. Frame of the table. [m]
class FailedAttempts {
 public:
  /// Two points are one place if they are at most `radius` apart.
  explicit FailedAttempts(double radius) : radius_(radius) {}

  void add(const Eigen::Vector3d& point) { points_.push_back(point); }
  /// Attempts that failed at the place of a point.
  int at(const Eigen::Vector3d& point) const;
  /// Attempts that failed in a box, or at most a place outside it: on the object in that box, if
  /// it has not moved since.
  int in(const Box& box) const;

 private:
  double radius_;
  std::vector<Eigen::Vector3d> points_;
};

}  // namespace symscene
