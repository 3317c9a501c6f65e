#include "symscene/physics/grasp_world.hpp"

#ifdef SYMSCENE_HAS_MUJOCO

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "hand_in_world.hpp"
#include "symscene/core/error.hpp"
#include "world_description.hpp"

namespace symscene {
namespace {

constexpr double away = 500.0;  // height of an absent hand [m]

/// The carriage slides along the axes of the world; the palm's orientation in it is set when the
/// hand is put.
std::string describe_hand(const ParallelHand& hand, const GraspWorldOptions& options) {
  const double mass = hand.palm_mass + 2.0 * hand.finger_mass;
  const double damping = 2.0 * std::sqrt(options.hand_stiffness * mass);  // critical
  std::string text =
      "<body name=\"carriage\"><inertial pos=\"0 0 0\" mass=\"0.001\" "
      "diaginertia=\"1e-6 1e-6 1e-6\"/>\n";
  constexpr std::array axes{"1 0 0", "0 1 0", "0 0 1"};
  for (std::size_t k = 0; k < axes.size(); ++k)
    text += fmt::format("<joint name=\"slide{}\" type=\"slide\" axis=\"{}\" damping=\"{}\"/>\n", k,
                        axes[k], damping);
  return text + describe_palm(hand, options) + "</body>\n";
}

std::string describe_forces(const ParallelHand& hand, const GraspWorldOptions& options) {
  std::string text = describe_finger_coupling() + "<actuator>\n";
  for (int k = 0; k < 3; ++k)
    text += fmt::format(
        "<position joint=\"slide{}\" kp=\"{}\" forcelimited=\"true\" forcerange=\"-{} {}\"/>\n", k,
        options.hand_stiffness, options.hand_force, options.hand_force);
  return text + describe_finger_actuators(hand) + "</actuator>\n";
}

std::string describe_world(std::span<const WeighedBody> bodies, const ParallelHand& hand,
                           std::span<const FixedBox> fixed, const GraspWorldOptions& options) {
  return describe_options(bodies.size(), options) + describe_assets(bodies, hand) + "<worldbody>" +
         describe_bodies(bodies, fixed, options) + describe_hand(hand, options) + "</worldbody>\n" +
         describe_forces(hand, options) + "</mujoco>\n";
}

}  // namespace

struct GraspWorld::Implementation : WorldWithHand {
  bool hand_is_there = false;

  int carriage() const { return static_cast<int>(is_there.size()) + 1; }
  double* hand_position() const { return data->qpos + 7 * is_there.size(); }
  double* hand_velocity() const { return data->qvel + 6 * is_there.size(); }

  /// Places the open hand at rest.
  void hold_hand(const Eigen::Vector3d& position) const {
    Eigen::Map<Eigen::Vector3d>{hand_position()} = position;
    std::fill_n(hand_velocity(), 3, 0.0);
    hold_open();
    aim(position);
  }
  void aim(const Eigen::Vector3d& target) const {
    Eigen::Map<Eigen::Vector3d>{data->ctrl} = target;
  }
  void set_hand(bool on) {
    hand_is_there = on;
    show_hand(on);
    close_fingers(false);
    const double weight = 9.81 * model->body_subtreemass[carriage()];
    data->qfrc_applied[6 * is_there.size() + 2] = weight;
  }
  void step_with_hand() const {
    if (!hand_is_there) hold_hand({0, 0, away});
    step();
  }
};

GraspWorld::GraspWorld(std::span<const WeighedBody> bodies, const ParallelHand& hand,
                       std::span<const FixedBox> fixed, const GraspWorldOptions& options)
    : implementation_(std::make_unique<Implementation>()) {
  options.validate();
  WorldWithHand::require_valid(bodies, hand);
  implementation_->begin(compile_model(describe_world(bodies, hand, fixed, options)), bodies, hand);
  take_hand_away();
}

GraspWorld::~GraspWorld() = default;
GraspWorld::GraspWorld(GraspWorld&&) noexcept = default;
GraspWorld& GraspWorld::operator=(GraspWorld&&) noexcept = default;

void GraspWorld::put(std::size_t body, const Eigen::Isometry3d& T_table_body) {
  implementation_->put(body, T_table_body);
}

void GraspWorld::take_away(std::size_t body) { implementation_->take_away(body); }

bool GraspWorld::is_there(std::size_t body) const { return implementation_->is_there[body]; }

std::size_t GraspWorld::size() const { return implementation_->is_there.size(); }

Eigen::Isometry3d GraspWorld::pose(std::size_t body) const { return implementation_->pose(body); }

double GraspWorld::speed(std::size_t body) const { return implementation_->speed(body); }

bool GraspWorld::touches(std::size_t body) const { return implementation_->touches(body); }

void GraspWorld::show_fixed(bool on) { implementation_->show_fixed(on); }

void GraspWorld::put_hand(const Eigen::Isometry3d& T_table_tool) {
  Implementation& world = *implementation_;
  world.set_hand(true);
  const Eigen::Quaterniond q(T_table_tool.linear());
  Eigen::Map<Eigen::Vector4d>(world.model->body_quat + 4 * world.palm) << q.w(), q.x(), q.y(),
      q.z();
  world.hold_hand(T_table_tool.translation());
}

void GraspWorld::take_hand_away() { implementation_->set_hand(false); }

void GraspWorld::pull_hand_to(const Eigen::Vector3d& target_table) {
  implementation_->aim(target_table);
}

void GraspWorld::close_fingers(bool on) { implementation_->close_fingers(on); }

double GraspWorld::opening() const { return implementation_->opening(); }

Eigen::Isometry3d GraspWorld::hand_pose() const {
  const Implementation& world = *implementation_;
  return pose_of(world.hand_position(), world.model->body_quat + 4 * world.palm);
}

HandContacts GraspWorld::hand_contacts() const { return implementation_->hand_contacts(); }

void GraspWorld::advance(double seconds) {
  const auto steps = std::lround(seconds / implementation_->time_step);
  for (long step = 0; step < steps; ++step) implementation_->step_with_hand();
}

}  // namespace symscene

#else

#include "symscene/core/error.hpp"

namespace symscene {

struct GraspWorld::Implementation {};
GraspWorld::GraspWorld(std::span<const WeighedBody>, const ParallelHand&, std::span<const FixedBox>,
                       const GraspWorldOptions&) {
  throw InputError("this build of SymScene",
                   "physics (the package libmujoco-dev, then configure and build again)", "none");
}
GraspWorld::~GraspWorld() = default;
GraspWorld::GraspWorld(GraspWorld&&) noexcept = default;
GraspWorld& GraspWorld::operator=(GraspWorld&&) noexcept = default;
void GraspWorld::put(std::size_t, const Eigen::Isometry3d&) {}
void GraspWorld::take_away(std::size_t) {}
bool GraspWorld::is_there(std::size_t) const { return false; }
std::size_t GraspWorld::size() const { return 0; }
Eigen::Isometry3d GraspWorld::pose(std::size_t) const { return Eigen::Isometry3d::Identity(); }
double GraspWorld::speed(std::size_t) const { return 0.0; }
bool GraspWorld::touches(std::size_t) const { return false; }
void GraspWorld::show_fixed(bool) {}
void GraspWorld::put_hand(const Eigen::Isometry3d&) {}
void GraspWorld::take_hand_away() {}
void GraspWorld::pull_hand_to(const Eigen::Vector3d&) {}
void GraspWorld::close_fingers(bool) {}
double GraspWorld::opening() const { return 0.0; }
Eigen::Isometry3d GraspWorld::hand_pose() const { return Eigen::Isometry3d::Identity(); }
HandContacts GraspWorld::hand_contacts() const { return {}; }
void GraspWorld::advance(double) {}

}  // namespace symscene

#endif
