#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// A piece of a joint path, by its arc length: a straight line or a circular arc. [rad or m]
struct PathSegment {
  Eigen::VectorXd start;
  Eigen::VectorXd tangent;  ///< unit vector at the start
  Eigen::VectorXd normal;   ///< unit vector from the start to the centre of an arc; of a line empty
  double radius = 0.0;      ///< of an arc
  double length = 0.0;

  bool is_line() const { return normal.size() == 0; }
  Eigen::VectorXd position(double s) const;
  /// The derivative of the position by s, a unit vector.
  Eigen::VectorXd first_derivative(double s) const;
  Eigen::VectorXd second_derivative(double s) const;
};

/// Waypoints joined by straight lines, their corners rounded by circular arcs (Kunz and Stilman
/// 2012, section IV). A corner that turns back, or any with no deviation allowed, stays: the
/// robot stops there.
class JointPath {
 public:
  /// An arc leaves its waypoint by at most `max_deviation`, and takes at most half of each line.
  /// Waypoints are N ≥ 1 vectors of equal size without wrapping: a continuous joint takes the way
  /// that the numbers say. Waypoints that repeat the one before or lie on the line between their
  /// neighbours are dropped. Throws InputError if a number is not finite or sizes differ.
  JointPath(const std::vector<Eigen::VectorXd>& waypoints, double max_deviation);

  const std::vector<PathSegment>& segments() const { return segments_; }
  /// Whether the robot has to stop at the end of a segment.
  bool stops_after(std::size_t segment) const { return stops_[segment]; }
  const Eigen::VectorXd& first() const { return first_; }
  const Eigen::VectorXd& last() const { return last_; }
  double length() const;

 private:
  void add_line(const Eigen::VectorXd& from, const Eigen::VectorXd& to);

  Eigen::VectorXd first_;
  Eigen::VectorXd last_;
  std::vector<PathSegment> segments_;
  std::vector<bool> stops_;
};

}  // namespace symscene
