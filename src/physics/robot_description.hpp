#pragma once

#include <string>

#include "symscene/robots/robot_model.hpp"

namespace symscene {

/// The attributes pos and quat of a pose.
std::string describe_pose(const Eigen::Isometry3d& pose);

/// The names of a robot's link and joint in MJCF.
std::string mjcf_link(std::size_t link);
std::string mjcf_joint(std::size_t joint);

/// The links of a robot as nested bodies, with `mounted` inside the body of link `mount`. Links
/// meet bodies and the table, but not each other.
std::string describe_robot(const RobotModel& model, const Eigen::Isometry3d& T_table_base,
                           double armature, std::size_t mount, const std::string& mounted);

}  // namespace symscene
