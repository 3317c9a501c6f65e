#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace symscene {

/// Bounds of a joint's motion; radians for a turning joint, metres for a sliding one. Infinite
/// where a bound is unknown; a continuous joint has the range [−π, π], one full turn.
struct JointLimits {
  double lower = 0.0;
  double upper = 0.0;
  double velocity = 0.0;      ///< greatest speed [1/s]
  double acceleration = 0.0;  ///< greatest acceleration [1/s²]
};

enum class JointKind : std::uint8_t { fixed, revolute, continuous, prismatic };

/// All points within `radius` of a segment. [m]
struct Capsule {
  Eigen::Vector3d begin = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

/// A rigid body; its capsules are in its own frame. Without capsules it collides with nothing.
struct Link {
  std::string name;
  std::vector<Capsule> capsules;
};

/// Connects two links: T_parent_child = T_parent_joint · (turn about, or slide along, `axis`).
struct Joint {
  std::string name;
  JointKind kind = JointKind::fixed;
  std::size_t parent = 0;  ///< index of the link nearer to the root
  std::size_t child = 0;   ///< index of the link that moves
  Eigen::Isometry3d T_parent_joint = Eigen::Isometry3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit vector in the joint's frame
  JointLimits limits;                               ///< of a moving joint
  std::optional<std::size_t> position;  ///< index into the vector of positions; none if fixed
};

/// A tree of links. "Base" is its root, links[0]. Positions of all moving joints stand in one
/// Eigen::VectorXd, in the order of the joints. [rad or m]
struct RobotModel {
  std::string name;
  std::vector<Link> links;    ///< parents before children
  std::vector<Joint> joints;  ///< joints[i] leads to links[i + 1], so that joints[i].child = i + 1
  /// Pairs of links, the lesser index first, ascending, that are not tested for collision with each
  /// other, beside those that ignores_collision() excludes by itself.
  std::vector<std::pair<std::size_t, std::size_t>> ignored_pairs;

  /// Number of moving joints: the size of a vector of positions.
  std::size_t moving_joints() const;
  /// Index of the joint whose position has that index.
  std::size_t joint_of_position(std::size_t position) const;
  /// Index of a link or joint; none of that name.
  std::optional<std::size_t> find_link(std::string_view link) const;
  std::optional<std::size_t> find_joint(std::string_view joint) const;
  /// Throws InputError, with the nearest name, if there is none of that name.
  std::size_t link_index(std::string_view link) const;
  std::size_t joint_index(std::string_view joint) const;

  /// Throws InputError if links and joints are no tree in the stated order, a name occurs twice, a
  /// number is not finite (a bound may be infinite), an axis is not a unit vector, or a joint's
  /// lower limit exceeds its upper one.
  void validate() const;
};

/// The chain from one link to another, which moves with it.
struct Arm {
  std::string name;
  std::size_t base_link = 0;
  std::size_t tip_link = 0;
  std::vector<std::size_t> joints;     ///< all joints from base to tip, fixed ones too
  std::vector<std::size_t> positions;  ///< of its moving joints: indices into the positions
};

/// The chain between two links. Throws InputError if there is no such link, or the tip is not
/// carried by the base. An arm may have no joint.
Arm make_arm(const RobotModel& model, std::string_view name, std::string_view base_link,
             std::string_view tip_link);

/// T_base_link of every link. Throws InputError unless there is one finite position per moving
/// joint.
std::vector<Eigen::Isometry3d> link_poses(const RobotModel& model,
                                          const Eigen::VectorXd& positions);

/// The positions of an arm's joints, in the order of the chain, and all positions with those of the
/// arm replaced.
Eigen::VectorXd arm_positions(const Arm& arm, const Eigen::VectorXd& positions);
Eigen::VectorXd with_arm_positions(const Arm& arm, const Eigen::VectorXd& arm_positions,
                                   Eigen::VectorXd positions);

/// For each link, the least index of a link that it is rigidly connected with: links of one body
/// have the same number.
std::vector<std::size_t> rigid_bodies(const RobotModel& model);

/// Whether two links are not tested for collision: one of them has no capsules, they belong to one
/// body, to bodies that a joint connects, or to `ignored_pairs`.
bool ignores_collision(const RobotModel& model, std::size_t link_a, std::size_t link_b);

/// All pairs of links that are tested for collision with each other, the lesser index first.
std::vector<std::pair<std::size_t, std::size_t>> self_collision_pairs(const RobotModel& model);

}  // namespace symscene
