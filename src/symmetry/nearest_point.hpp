#pragma once

#include <Eigen/Dense>

namespace symscene {

/// The point nearest to lines and planes in the least-squares sense. Directions that these leave
/// open are kept near `start` by a small weight.
class NearestPoint {
 public:
  NearestPoint(const Eigen::Vector3d& start, double start_weight)
      : sum_(start_weight * Eigen::Matrix3d::Identity()), target_(start_weight * start) {}

  /// `direction` and `normal` are unit vectors.
  void add_line(const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
    add(Eigen::Matrix3d::Identity() - direction * direction.transpose(), point);
  }
  void add_plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    add(normal * normal.transpose(), point);
  }
  Eigen::Vector3d solve() const { return sum_.ldlt().solve(target_); }

 private:
  void add(const Eigen::Matrix3d& across, const Eigen::Vector3d& point) {
    sum_ += across;
    target_ += across * point;
  }

  Eigen::Matrix3d sum_;
  Eigen::Vector3d target_;
};

}  // namespace symscene
