#include "robot_choice.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/number_in.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/types.hpp"
#include "symscene/io/robot.hpp"
#include "text_list.hpp"

namespace symscene::app {
namespace {

double number_of(std::string_view text, const std::string& where) {
  const auto number = number_in<double>(text);
  if (number && std::isfinite(*number)) return *number;
  throw InputError(where, "numbers", fmt::format("\"{}\"", text));
}

/// Runs `work`. An InputError from it names `option` in place of what it named.
template <class Work>
decltype(auto) naming_option(const char* option, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(option, error.expected(), error.found());
  }
}

void set_position(const RobotModel& model, std::size_t joint_index, double value,
                  Eigen::VectorXd& positions) {
  const Joint& joint = model.joints[joint_index];
  const std::string where = "--start: " + joint.name;
  if (!joint.position) throw InputError(where, "a joint that moves", "one that does not");
  const bool is_bounded = joint.kind != JointKind::continuous;
  if (is_bounded && (value < joint.limits.lower || value > joint.limits.upper))
    throw InputError(
        where, fmt::format("a position in [{:g}, {:g}]", joint.limits.lower, joint.limits.upper),
        fmt::format("{:g}", value));
  positions[static_cast<Eigen::Index>(*joint.position)] = value;
}

}  // namespace

Eigen::Isometry3d parse_pose(const std::string& text, const std::string& where) {
  std::vector<double> n;
  for (const std::string& item : separated(text)) n.push_back(number_of(item, where));
  if (n.size() != 4 && n.size() != 7)
    throw InputError(where, "x,y,z,yaw or x,y,z,qx,qy,qz,qw", fmt::format("{} numbers", n.size()));
  Eigen::Isometry3d pose(Eigen::Translation3d(n[0], n[1], n[2]));
  if (n.size() == 4) {
    pose.rotate(Eigen::AngleAxisd(radians(n[3]), Eigen::Vector3d::UnitZ()));
    return pose;
  }
  const Eigen::Quaterniond q(n[6], n[3], n[4], n[5]);
  if (!(std::abs(q.norm() - 1.0) < 1e-3))
    throw InputError(where, "a unit quaternion qx,qy,qz,qw", fmt::format("{:g} long", q.norm()));
  pose.linear() = q.normalized().toRotationMatrix();
  return pose;
}

Robot named_robot(const std::string& name) {
  try {
    return read_robot(name);
  } catch (const InputError& error) {
    if (error.where() != "robot") throw;  // the name of a file
    throw InputError("--robot", error.expected(), error.found());
  }
}

void RobotChoice::add_to(Arguments& arguments) {
  arguments.text("--robot", "NAME|FILE", name,
                 fmt::format("{}, or a YAML file that describes a robot (default panda)",
                             fmt::join(robot_names(), ", ")));
  arguments.text("--arm", "NAME", arm_name, "name of the arm (default: the first with a gripper)");
  arguments.text("--base", "POSE", base,
                 "pose of the robot's root link in the frame of the scene: x,y,z,yaw [m, degrees] "
                 "or x,y,z,qx,qy,qz,qw (default: base_pose of the robot's description)");
  arguments.text("--start", "POSITIONS", start,
                 "where the joints are [rad or m]: one number per joint of the arm, in its order, "
                 "or NAME=NUMBER of any joints; separated by commas (default: home)");
}

Robot RobotChoice::robot() const {
  Robot robot = named_robot(name);
  if (!base.empty()) robot.T_world_base = parse_pose(base, "--base");
  return robot;
}

std::optional<std::string> RobotChoice::check_stand(const Robot& robot,
                                                    const std::optional<Plane>& table) const {
  constexpr double most = radians(20.0);
  if (!table) return std::nullopt;
  const double angle = angle_between(table->normal, robot.T_world_base.linear().col(2));
  if (angle <= most) return std::nullopt;
  if (separated(base).size() != 7)
    throw InputError(
        "--base",
        "the robot's pose in the frame of the scene as x,y,z,qx,qy,qz,qw, as the table "
        "of the scene is tilted",
        fmt::format("{}, at which the robot leans {:.0f} degrees against the table",
                    base.empty() ? "base_pose of its description" : base, degrees(angle)));
  return fmt::format("the robot leans {:.0f} degrees against the table, as --base says",
                     degrees(angle));
}

const RobotArm& RobotChoice::arm(const Robot& robot) const {
  if (arm_name.empty()) return robot.grasping_arm();
  return naming_option("--arm", [&]() -> const RobotArm& { return robot.arm(arm_name); });
}

Eigen::VectorXd RobotChoice::start_positions(const Robot& robot, const Arm& arm) const {
  Eigen::VectorXd positions = robot.home;
  if (start.empty()) return positions;
  const RobotModel& model = robot.model;
  const std::vector<std::string> items = separated(start);
  const bool is_named = start.find('=') != std::string::npos;
  if (!is_named && items.size() != arm.positions.size())
    throw InputError("--start", fmt::format("{} numbers", arm.positions.size()),
                     std::to_string(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::size_t equals = items[i].find('=');
    if (is_named && equals == std::string::npos)
      throw InputError("--start", "NAME=NUMBER", fmt::format("\"{}\"", items[i]));
    const std::size_t joint =
        is_named ? naming_option("--start",
                                 [&] { return model.joint_index(items[i].substr(0, equals)); })
                 : model.joint_of_position(arm.positions[i]);
    set_position(model, joint,
                 number_of(is_named ? items[i].substr(equals + 1) : items[i], "--start"),
                 positions);
  }
  return positions;
}

}  // namespace symscene::app
