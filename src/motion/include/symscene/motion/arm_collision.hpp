#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "symscene/motion/motion_obstacles.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene {

struct ArmCollisionOptions {
  double clearance = 0.005;
  double hand_clearance = 0.001;
  double held_depth = 0.01;
  double held_clearance = 0.001;
  double lift_slack = 0.001;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("clearance", self.clearance, "m", above_up_to(0.0, 0.02),
          "least distance of the links from obstacles and from each other");
    visit("hand_clearance", self.hand_clearance, "m", above_up_to(0.0, 0.02),
          "least distance of the gripper from obstacles; a grasp's own bounds are stricter");
    visit(
        "held_depth", self.held_depth, "m", above_up_to(0.0, 0.1),
        "how deep the completed surface of a held object may reach into an obstacle; it stands on "
        "the table and is not known exactly");
    visit(
        "held_clearance", self.held_clearance, "m", between(-0.1, 0.02),
        "least distance of the held object from obstacles other than the table. Surfaces are balls "
        "of 3 mm: below -3 mm it may pass through them");
    visit("lift_slack", self.lift_slack, "m", above_up_to(0.0, 0.05),
          "where the held object is nearer than held_clearance to others before the lift, as it is "
          "to neighbours that it touches: how much nearer it may come in the lift");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// A part of the robot that is too near to something.
struct RobotContact {
  std::string part;        ///< a link's name, "gripper" or "held object"
  ObstacleDistance other;  ///< what it meets
  std::string other_link;  ///< of kind `robot`
  double bound = 0.0;      ///< least distance that is allowed [m]
};

/// "gripper meets object 3 by 4 mm", "link5 is 2 mm from the table (5 mm required)".
std::string describe(const RobotContact& contact);

/// Where an arm may be, with the gripper on its tip and what that holds. Other joints of the robot
/// keep their positions. Links that the arm does not move are tested against those that it moves,
/// but not against the scene: the robot stands there. So is a link that a vertical axis alone
/// turns not tested against the table. From the tip link on, the gripper's boxes stand for the
/// links.
class ArmCollision {
 public:
  /// `gripper`: nullptr for none. `opening`: of its fingers. [m] References are kept. Throws
  /// InputError if an option is invalid or `positions` has another size.
  ArmCollision(const Robot& robot, const RobotArm& arm, const Gripper* gripper, double opening,
               const MotionObstacles& obstacles, const Eigen::VectorXd& positions,
               const ArmCollisionOptions& options = {});
  ~ArmCollision();
  ArmCollision(ArmCollision&&) noexcept;

  /// From now on the gripper holds these points of its tool frame. [m]
  void hold(const std::vector<Eigen::Vector3f>& points_tool);
  /// From now on the held object may be as near to obstacles as it is at these positions, and
  /// `lift_slack` nearer: it may touch its neighbours before it is lifted.
  void allow_contacts_at(const Eigen::VectorXd& arm_positions, const IgnoredObstacles& ignored);

  /// The first contact at positions of the arm's joints; none if there is no contact.
  std::optional<RobotContact> contact(const Eigen::VectorXd& arm_positions,
                                      const IgnoredObstacles& ignored = {}) const;
  /// Whether the straight motion between two configurations is free: conservative advancement, each
  /// step shorter than the way that any point needs to the obstacle nearest to its part. No
  /// obstacle is passed over, however thin. With `met`, that is where it is not free.
  bool is_free(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
               const IgnoredObstacles& ignored = {}, RobotContact* met = nullptr) const;

  /// Capsules of all links in the world, at positions of the arm's joints; of the gripper too.
  std::vector<Capsule> capsules(const Eigen::VectorXd& arm_positions) const;

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace symscene
