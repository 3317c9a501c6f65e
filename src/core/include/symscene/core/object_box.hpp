#pragma once

#include <Eigen/Geometry>

namespace symscene {

/// A pose as position and unit quaternion, which files hold without rounding.
struct ObjectPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();

  Eigen::Isometry3d transform() const {
    return Eigen::Translation3d(position) * Eigen::Isometry3d(orientation);
  }
};

/// A frame that is fixed to an object, and the box around the object along its axes. World frame.
/// Of an object with symmetries the planes and axes of its class go through the origin, and the
/// axes of the frame are theirs. Turns and reflections of the class itself leave the object as it
/// is, so that the frame is known up to them.
struct ObjectBox {
  ObjectPose T_world_object;
  ObjectPose T_world_box;  ///< the same orientation, the origin in the middle of the box
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< edges along the three axes [m]
};

}  // namespace symscene
