#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// Remembers where attempts failed, by the points between the finger tips. Two points are one place
/// if they are at most `radius` apart. [m]
class FailedPlaces {
 public:
  explicit FailedPlaces(double radius) : radius_(radius) {}

  void add(const Eigen::Vector3d& point) { points_.push_back(point); }
  /// Attempts that failed at the place of a point.
  int failures_at(const Eigen::Vector3d& point) const;

 private:
  double radius_;
  std::vector<Eigen::Vector3d> points_;
};

}  // namespace symscene
