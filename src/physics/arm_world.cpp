#include "symscene/physics/arm_world.hpp"

#ifdef SYMSCENE_HAS_MUJOCO

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "hand_in_world.hpp"
#include "robot_description.hpp"
#include "symscene/core/error.hpp"
#include "world_description.hpp"

namespace symscene {
namespace {

/// Height of the lowest point of a link above the table; infinite without capsules. [m]
double lowest_point(const Link& link, const Eigen::Isometry3d& T_table_link) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Capsule& capsule : link.capsules) {
    for (const Eigen::Vector3d& end : {capsule.begin, capsule.end})
      lowest = std::min(lowest, (T_table_link * end).z() - capsule.radius);
  }
  return lowest;
}

/// Links that reach into the table at home stand there. A contact that never ends, with forces that
/// no joint can yield to, would make the solver diverge.
std::string describe_standing_links(const Robot& robot, const Eigen::Isometry3d& T_table_base) {
  const std::vector<Eigen::Isometry3d> poses = link_poses(robot.model, robot.home);
  std::string text;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (lowest_point(robot.model.links[i], T_table_base * poses[i]) < 0.0)
      text += "<exclude body1=\"world\" body2=\"" + mjcf_link(i) + "\"/>\n";
  }
  return text.empty() ? text : "<contact>\n" + text + "</contact>\n";
}

std::string describe_world(std::span<const WeighedBody> bodies, const Robot& robot,
                           const Eigen::Isometry3d& T_table_base, const Arm& arm,
                           const Eigen::Isometry3d& T_tip_tool, const ParallelHand& hand,
                           std::span<const FixedBox> fixed, const ArmWorldOptions& options) {
  const std::string palm = describe_palm(hand, options.contacts, describe_pose(T_tip_tool));
  return describe_options(bodies.size(), options.contacts) + describe_assets(bodies, hand) +
         "<worldbody>" + describe_bodies(bodies, fixed, options.contacts) +
         describe_robot(robot.model, T_table_base, options.armature, arm.tip_link, palm) +
         "</worldbody>\n" + describe_standing_links(robot, T_table_base) +
         describe_finger_coupling() + "<actuator>\n" + describe_finger_actuators(hand) +
         "</actuator>\n</mujoco>\n";
}

void require_positions(const Eigen::VectorXd& positions, const RobotModel& model) {
  const auto found = static_cast<double>(positions.size());
  require_option(positions.size() == static_cast<Eigen::Index>(model.moving_joints()), "positions",
                 "one per moving joint", found);
  require_option(positions.allFinite(), "positions", "finite numbers", NAN);
}

}  // namespace

struct ArmWorld::Implementation : WorldWithHand {
  ArmWorldOptions options;
  RobotModel robot;
  std::vector<int> position_address;  ///< per moving joint: in qpos
  std::vector<int> velocity_address;  ///< the same in qvel
  Eigen::VectorXd target;
  Eigen::VectorXd target_velocity;

  void find_joints() {
    for (std::size_t k = 0; k < robot.moving_joints(); ++k) {
      const std::string name = mjcf_joint(robot.joint_of_position(k));
      const int joint = mj_name2id(model.get(), mjOBJ_JOINT, name.c_str());
      position_address.push_back(model->jnt_qposadr[joint]);
      velocity_address.push_back(model->jnt_dofadr[joint]);
    }
  }

  Eigen::VectorXd positions() const {
    Eigen::VectorXd q(static_cast<Eigen::Index>(position_address.size()));
    for (std::size_t k = 0; k < position_address.size(); ++k)
      q[static_cast<Eigen::Index>(k)] = data->qpos[position_address[k]];
    return q;
  }

  /// Torques of the computed-torque method: M (ω² e + 2 ω ė) + bias. The drives bound what goes
  /// beyond the bias.
  void control() const {
    const double w = options.servo_frequency;
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(model->nv), force(model->nv);
    for (std::size_t k = 0; k < velocity_address.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      const double error = target[i] - data->qpos[position_address[k]];
      const double rate = target_velocity[i] - data->qvel[velocity_address[k]];
      wanted[velocity_address[k]] = w * w * error + 2.0 * w * rate;
    }
    mj_mulM(model.get(), data.get(), force.data(), wanted.data());
    for (const int dof : velocity_address)
      data->qfrc_applied[dof] =
          std::clamp(force[dof], -options.joint_force, options.joint_force) + data->qfrc_bias[dof];
  }

  /// Whether this body of MuJoCo is a link of the robot.
  bool is_link(int body) const {
    return body > static_cast<int>(is_there.size()) && !is_hand(body);
  }
  bool is_hand(int body) const { return body >= palm && body <= finger(1); }
};

ArmWorld::ArmWorld(std::span<const WeighedBody> bodies, const Robot& robot,
                   const Eigen::Isometry3d& T_table_base, const Arm& arm,
                   const Eigen::Isometry3d& T_tip_tool, const ParallelHand& hand,
                   std::span<const FixedBox> fixed, const ArmWorldOptions& options)
    : implementation_(std::make_unique<Implementation>()) {
  options.validate();
  WorldWithHand::require_valid(bodies, hand);
  robot.model.validate();
  Implementation& world = *implementation_;
  world.options = options;
  world.robot = robot.model;
  world.begin(compile_model(describe_world(bodies, robot, T_table_base, arm, T_tip_tool, hand,
                                           fixed, options)),
              bodies, hand);
  world.find_joints();
  world.show_hand(true);
  world.show_fixed(true);
  put_robot(robot.home);
}

ArmWorld::~ArmWorld() = default;
ArmWorld::ArmWorld(ArmWorld&&) noexcept = default;
ArmWorld& ArmWorld::operator=(ArmWorld&&) noexcept = default;

void ArmWorld::put(std::size_t body, const Eigen::Isometry3d& T_table_body) {
  implementation_->put(body, T_table_body);
}

void ArmWorld::take_away(std::size_t body) { implementation_->take_away(body); }

bool ArmWorld::is_there(std::size_t body) const { return implementation_->is_there[body]; }

std::size_t ArmWorld::size() const { return implementation_->is_there.size(); }

Eigen::Isometry3d ArmWorld::pose(std::size_t body) const { return implementation_->pose(body); }

double ArmWorld::speed(std::size_t body) const { return implementation_->speed(body); }

void ArmWorld::put_robot(const Eigen::VectorXd& positions) {
  Implementation& world = *implementation_;
  require_positions(positions, world.robot);
  for (std::size_t k = 0; k < world.position_address.size(); ++k) {
    world.data->qpos[world.position_address[k]] = positions[static_cast<Eigen::Index>(k)];
    world.data->qvel[world.velocity_address[k]] = 0.0;
  }
  world.hold_open();
  world.close_fingers(false);
  aim_robot(positions, Eigen::VectorXd::Zero(positions.size()));
}

void ArmWorld::aim_robot(const Eigen::VectorXd& positions, const Eigen::VectorXd& velocities) {
  require_positions(positions, implementation_->robot);
  require_positions(velocities, implementation_->robot);
  implementation_->target = positions;
  implementation_->target_velocity = velocities;
}

Eigen::VectorXd ArmWorld::positions() const { return implementation_->positions(); }

Eigen::Isometry3d ArmWorld::hand_pose() const {
  const Implementation& world = *implementation_;
  mj_kinematics(world.model.get(), world.data.get());
  return pose_of(world.data->xpos + 3 * world.palm, world.data->xquat + 4 * world.palm);
}

void ArmWorld::close_fingers(bool on) { implementation_->close_fingers(on); }

double ArmWorld::opening() const { return implementation_->opening(); }

HandContacts ArmWorld::hand_contacts() const { return implementation_->hand_contacts(); }

ArmContacts ArmWorld::arm_contacts() const {
  const Implementation& world = *implementation_;
  world.find_contacts();
  ArmContacts contacts;
  std::vector<bool> touched(size());
  world.for_each_contact([&](int link, int other, double) {
    if (!world.is_link(link)) return;
    if (other == 0) contacts.table = true;
    if (other > 0 && other <= static_cast<int>(size()))
      touched[static_cast<std::size_t>(other - 1)] = true;
  });
  for (std::size_t b = 0; b < size(); ++b) {
    if (touched[b]) contacts.bodies.push_back(b);
  }
  return contacts;
}

void ArmWorld::advance(double seconds) {
  const Implementation& world = *implementation_;
  const auto steps = std::lround(seconds / world.time_step);
  for (long step = 0; step < steps; ++step) world.step([&] { world.control(); });
}

}  // namespace symscene

#else

#include "symscene/core/error.hpp"

namespace symscene {

struct ArmWorld::Implementation {};
ArmWorld::ArmWorld(std::span<const WeighedBody>, const Robot&, const Eigen::Isometry3d&, const Arm&,
                   const Eigen::Isometry3d&, const ParallelHand&, std::span<const FixedBox>,
                   const ArmWorldOptions&) {
  throw InputError("this build of SymScene",
                   "physics (the package libmujoco-dev, then configure and build again)", "none");
}
ArmWorld::~ArmWorld() = default;
ArmWorld::ArmWorld(ArmWorld&&) noexcept = default;
ArmWorld& ArmWorld::operator=(ArmWorld&&) noexcept = default;
void ArmWorld::put(std::size_t, const Eigen::Isometry3d&) {}
void ArmWorld::take_away(std::size_t) {}
bool ArmWorld::is_there(std::size_t) const { return false; }
std::size_t ArmWorld::size() const { return 0; }
Eigen::Isometry3d ArmWorld::pose(std::size_t) const { return Eigen::Isometry3d::Identity(); }
double ArmWorld::speed(std::size_t) const { return 0.0; }
void ArmWorld::put_robot(const Eigen::VectorXd&) {}
void ArmWorld::aim_robot(const Eigen::VectorXd&, const Eigen::VectorXd&) {}
Eigen::VectorXd ArmWorld::positions() const { return {}; }
Eigen::Isometry3d ArmWorld::hand_pose() const { return Eigen::Isometry3d::Identity(); }
void ArmWorld::close_fingers(bool) {}
double ArmWorld::opening() const { return 0.0; }
HandContacts ArmWorld::hand_contacts() const { return {}; }
ArmContacts ArmWorld::arm_contacts() const { return {}; }
void ArmWorld::advance(double) {}

}  // namespace symscene

#endif
