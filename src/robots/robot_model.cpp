#include "symscene/robots/robot_model.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/nearest_name.hpp"
#include "joint_motion.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

template <class Item>
std::vector<std::string> names_of(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.name);
  return names;
}

template <class Item>
std::optional<std::size_t> find_name(const std::vector<Item>& items, std::string_view name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
  if (found == items.end()) return std::nullopt;
  return static_cast<std::size_t>(found - items.begin());
}

template <class Item>
std::size_t index_of_name(const RobotModel& model, const std::vector<Item>& items,
                          std::string_view name, const char* what) {
  if (const auto found = find_name(items, name)) return *found;
  throw InputError("robot " + model.name, fmt::format("the name of a {}", what),
                   with_nearest_name(name, names_of(items)));
}

template <class Item>
void require_unique_names(const std::string& where, const std::vector<Item>& items) {
  std::set<std::string> names;
  for (const Item& item : items) {
    if (!names.insert(item.name).second)
      throw InputError(where, "one link or joint of each name",
                       fmt::format("\"{}\" twice", item.name));
  }
}

void validate_capsules(const std::string& robot, const Link& link) {
  for (const Capsule& capsule : link.capsules) {
    if (!capsule.begin.allFinite() || !capsule.end.allFinite() || !(capsule.radius > 0.0) ||
        !std::isfinite(capsule.radius))
      throw InputError(fmt::format("{}, link {}", robot, link.name),
                       "capsules with finite ends and a radius above 0",
                       fmt::format("a radius of {:g}", capsule.radius));
  }
}

void validate_limits(const std::string& where, const JointLimits& limits) {
  const double lower = limits.lower, upper = limits.upper;
  if (!(lower <= upper))
    throw InputError(where, "a lower limit that is at most the upper one",
                     fmt::format("{:g} and {:g}", lower, upper));
  if (!(limits.velocity > 0.0) || !(limits.acceleration > 0.0))
    throw InputError(
        where, "limits of velocity and acceleration above 0",
        fmt::format("velocity {:g}, acceleration {:g}", limits.velocity, limits.acceleration));
}

void validate_joint(const std::string& robot, const Joint& joint, std::size_t child,
                    std::size_t& moving) {
  const std::string where = fmt::format("{}, joint {}", robot, joint.name);
  if (joint.child != child || joint.parent >= child)
    throw InputError(where, "parents before children, joint i leading to link i + 1",
                     fmt::format("parent {}, child {}", joint.parent, joint.child));
  if (!joint.T_parent_joint.matrix().allFinite() || !joint.axis.allFinite())
    throw InputError(where, "an origin and an axis of finite numbers", "another number");
  const bool moves = joint.kind != JointKind::fixed;
  if (joint.position != (moves ? std::optional(moving) : std::nullopt))
    throw InputError(where, "positions that number the moving joints", "another number");
  if (!moves) return;
  ++moving;
  if (!(std::abs(joint.axis.norm() - 1.0) < 1e-9))
    throw InputError(where, "an axis of unit length", fmt::format("{:g}", joint.axis.norm()));
  validate_limits(where, joint.limits);
}

/// The joints that lead from `base` to `tip`.
std::vector<std::size_t> chain_between(const RobotModel& model, std::size_t base, std::size_t tip) {
  std::vector<std::size_t> joints;
  for (std::size_t link = tip; link != base; link = model.joints[joints.back()].parent) {
    if (link == 0)
      throw InputError("robot " + model.name,
                       fmt::format("a tip link that {} carries", model.links[base].name),
                       model.links[tip].name);
    joints.push_back(link - 1);
  }
  std::reverse(joints.begin(), joints.end());
  return joints;
}

}  // namespace

std::size_t RobotModel::moving_joints() const {
  const auto moves = [](const Joint& joint) { return joint.position.has_value(); };
  return static_cast<std::size_t>(std::count_if(joints.begin(), joints.end(), moves));
}

std::size_t RobotModel::joint_of_position(std::size_t position) const {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].position == position) return i;
  }
  throw InputError("robot " + name, fmt::format("a position below {}", moving_joints()),
                   fmt::format("{}", position));
}

std::optional<std::size_t> RobotModel::find_link(std::string_view link) const {
  return find_name(links, link);
}

std::optional<std::size_t> RobotModel::find_joint(std::string_view joint) const {
  return find_name(joints, joint);
}

std::size_t RobotModel::link_index(std::string_view link) const {
  return index_of_name(*this, links, link, "link");
}

std::size_t RobotModel::joint_index(std::string_view joint) const {
  return index_of_name(*this, joints, joint, "joint");
}

void RobotModel::validate() const {
  const std::string where = "robot " + name;
  if (links.size() != joints.size() + 1)
    throw InputError(where, "one joint per link but the root",
                     fmt::format("{} links and {} joints", links.size(), joints.size()));
  require_unique_names(where, links);
  require_unique_names(where, joints);
  for (const Link& link : links) validate_capsules(where, link);
  std::size_t moving = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) validate_joint(where, joints[i], i + 1, moving);
  for (const auto& [a, b] : ignored_pairs) {
    if (a >= b || b >= links.size())
      throw InputError(where, "ignored pairs of two links, the lesser index first",
                       fmt::format("{} and {}", a, b));
  }
}

Arm make_arm(const RobotModel& model, std::string_view name, std::string_view base_link,
             std::string_view tip_link) {
  Arm arm;
  arm.name = name;
  arm.base_link = model.link_index(base_link);
  arm.tip_link = model.link_index(tip_link);
  arm.joints = chain_between(model, arm.base_link, arm.tip_link);
  for (const std::size_t joint : arm.joints) {
    if (const auto position = model.joints[joint].position) arm.positions.push_back(*position);
  }
  return arm;
}

std::vector<Eigen::Isometry3d> link_poses(const RobotModel& model,
                                          const Eigen::VectorXd& positions) {
  const auto moving = static_cast<Eigen::Index>(model.moving_joints());
  if (positions.size() != moving || !positions.allFinite())
    throw InputError("robot " + model.name, fmt::format("{} finite joint positions", moving),
                     fmt::format("{} numbers", positions.size()));
  std::vector<Eigen::Isometry3d> T_base_link(model.links.size(), Eigen::Isometry3d::Identity());
  for (const Joint& joint : model.joints) {
    const double q = joint.position ? positions[static_cast<Eigen::Index>(*joint.position)] : 0.0;
    T_base_link[joint.child] = T_base_link[joint.parent] * T_parent_child(joint, q);
  }
  return T_base_link;
}

Eigen::VectorXd arm_positions(const Arm& arm, const Eigen::VectorXd& positions) {
  Eigen::VectorXd of_arm(static_cast<Eigen::Index>(arm.positions.size()));
  for (std::size_t i = 0; i < arm.positions.size(); ++i)
    of_arm[static_cast<Eigen::Index>(i)] = positions[static_cast<Eigen::Index>(arm.positions[i])];
  return of_arm;
}

Eigen::VectorXd with_arm_positions(const Arm& arm, const Eigen::VectorXd& arm_positions,
                                   Eigen::VectorXd positions) {
  for (std::size_t i = 0; i < arm.positions.size(); ++i)
    positions[static_cast<Eigen::Index>(arm.positions[i])] =
        arm_positions[static_cast<Eigen::Index>(i)];
  return positions;
}

}  // namespace symscene
