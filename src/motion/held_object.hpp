#pragma once

#include <vector>

#include "symscene/motion/motion_obstacles.hpp"

namespace symscene {

/// Points of an object in a gripper, in groups with a ball around each, so that those far from all
/// obstacles are passed over as one.
class HeldObject {
 public:
  HeldObject() = default;
  /// `points`: in the frame of the tip link. [m]
  explicit HeldObject(const std::vector<Eigen::Vector3d>& points);

  bool empty() const { return groups_.empty(); }
  /// Greatest distance of a point from the origin of its frame. [m]
  double extent() const { return extent_; }
  /// The obstacle that is nearest to a point, the table too, if it is nearer than
  /// MotionObstacles::near; else that distance. The table counts as lying `table_depth` lower. [m]
  ObstacleDistance nearest(const MotionObstacles& obstacles, const Eigen::Isometry3d& T_world_tip,
                           const IgnoredObstacles& ignored, double table_depth = 0.0) const;

 private:
  struct Group {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double radius = 0.0;
    std::vector<Eigen::Vector3d> points = {};
  };

  std::vector<Group> groups_;
  double extent_ = 0.0;
};

}  // namespace symscene
