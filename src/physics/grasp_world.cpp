#include "symscene/physics/grasp_world.hpp"

#ifdef SYMSCENE_HAS_MUJOCO

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "mujoco_world.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr double reference_density = 1000.0;  // bodies are compiled with it, then weighed [kg/m³]
constexpr double full_force_distance =
    0.001;                      // of a finger from its target, from which it has its full force [m]
constexpr double away = 500.0;  // height of an absent hand [m]

std::string describe_options(const GraspWorldOptions& options) {
  return fmt::format(R"(<mujoco>
<compiler boundmass="1e-6" boundinertia="1e-12"/>
<size njmax="2500" nconmax="500"/>
<option timestep="{}" cone="elliptic" impratio="10"><flag multiccd="enable"/></option>
<default><geom condim="6" friction="{} {} {}" density="{}"
  solref="0.006 1" solimp="0.95 0.99 0.001"/></default>
)",
                     options.time_step, options.object_friction, options.torsional_friction,
                     options.rolling_friction, reference_density);
}

/// The finger that opens along -y.
ConvexParts turned(const ConvexParts& finger) {
  ConvexParts parts = finger;
  for (Points& part : parts) part.leftCols<2>() *= -1.0F;
  return parts;
}

std::string describe_hulls(const std::string& name, const ConvexParts& parts) {
  std::string text;
  for (std::size_t p = 0; p < parts.size(); ++p)
    append_hull(text, fmt::format("{}_{}", name, p), parts[p]);
  return text;
}

/// Where both surfaces have the same priority, MuJoCo takes the greater friction; otherwise that of
/// the surface with the higher one.
std::string describe_geoms(const std::string& name, const ConvexParts& parts,
                           const std::string& attributes = {}) {
  std::string text;
  for (std::size_t p = 0; p < parts.size(); ++p)
    text += fmt::format("<geom type=\"mesh\" mesh=\"{}_{}\" {}/>", name, p, attributes);
  return text;
}

std::string describe_fixed(std::span<const FixedBox> fixed, const std::string& friction) {
  std::string text = fmt::format("<geom type=\"plane\" size=\"0 0 1\" {}/>\n", friction);
  for (const FixedBox& box : fixed) {
    const Eigen::Vector3d middle = 0.5 * (box.min + box.max), half = 0.5 * (box.max - box.min);
    text += fmt::format(
        "<geom type=\"box\" pos=\"{} {} {}\" size=\"{} {} {}\" contype=\"0\" conaffinity=\"0\" "
        "{}/>\n",
        middle.x(), middle.y(), middle.z(), half.x(), half.y(), half.z(), friction);
  }
  return text;
}

/// A finger as a child of the palm. While it moves freely its damping balances its force.
std::string describe_finger(const char* name, double side, const ConvexParts& parts,
                            const ParallelHand& hand, const GraspWorldOptions& options) {
  return fmt::format(
      "<body name=\"{0}\"><joint name=\"{0}\" type=\"slide\" axis=\"0 {1} 0\" limited=\"true\" "
      "range=\"0 {2}\" damping=\"{3}\"/>{4}</body>\n",
      name, side, 0.5 * hand.max_opening, hand.force / hand.speed,
      describe_geoms(name, parts,
                     fmt::format("condim=\"4\" priority=\"1\" friction=\"{} {} 0.0001\"",
                                 options.finger_friction, options.finger_torsional_friction)));
}

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
  text += "<body name=\"palm\">" +
          describe_geoms("palm", hand.palm,
                         fmt::format("condim=\"3\" priority=\"1\" friction=\"{} 0.005 0.0001\"",
                                     options.palm_friction)) +
          "\n";
  text += describe_finger("left", 1.0, hand.finger, hand, options);
  text += describe_finger("right", -1.0, hand.finger, hand, options);
  return text + "</body></body>\n";
}

std::string describe_forces(const ParallelHand& hand, const GraspWorldOptions& options) {
  std::string text =
      "<equality><joint joint1=\"left\" joint2=\"right\" solref=\"0.01 1\"/></equality>\n"
      "<actuator>\n";
  for (int k = 0; k < 3; ++k)
    text += fmt::format(
        "<position joint=\"slide{}\" kp=\"{}\" forcelimited=\"true\" forcerange=\"-{} {}\"/>\n", k,
        options.hand_stiffness, options.hand_force, options.hand_force);
  for (const char* finger : {"left", "right"})
    text += fmt::format(
        "<position joint=\"{}\" kp=\"{}\" forcelimited=\"true\" forcerange=\"-{} {}\"/>\n", finger,
        hand.force / full_force_distance, hand.force, hand.force);
  return text + "</actuator>\n";
}

std::string describe_world(std::span<const WeighedBody> bodies, const ParallelHand& hand,
                           std::span<const FixedBox> fixed, const GraspWorldOptions& options) {
  std::string text = describe_options(options) + "<asset>\n";
  for (std::size_t b = 0; b < bodies.size(); ++b)
    text += describe_hulls(fmt::format("body{}", b), *bodies[b].parts);
  text += describe_hulls("palm", hand.palm) + describe_hulls("left", hand.finger) +
          describe_hulls("right", turned(hand.finger)) + "</asset>\n<worldbody>";
  text += describe_fixed(fixed,
                         fmt::format("priority=\"1\" friction=\"{} {} {}\"", options.table_friction,
                                     options.torsional_friction, options.rolling_friction));
  for (std::size_t b = 0; b < bodies.size(); ++b)
    text += "<body><freejoint/>" + describe_geoms(fmt::format("body{}", b), *bodies[b].parts) +
            "</body>\n";
  return text + describe_hand(hand, options) + "</worldbody>\n" + describe_forces(hand, options) +
         "</mujoco>\n";
}

/// Gives MuJoCo's body this mass, with the distribution that it has.
void weigh(mjModel& model, int body, double mass) {
  const double ratio = mass / model.body_mass[body];
  model.body_mass[body] = mass;
  for (int k = 0; k < 3; ++k) model.body_inertia[3 * body + k] *= ratio;
}

}  // namespace

struct GraspWorld::Implementation : MujocoWorld {
  ParallelHand hand;
  bool hand_is_there = false;

  int carriage() const { return static_cast<int>(is_there.size()) + 1; }
  int palm() const { return carriage() + 1; }
  int finger(int k) const { return carriage() + 2 + k; }
  double* hand_position() const { return data->qpos + 7 * is_there.size(); }
  double* hand_velocity() const { return data->qvel + 6 * is_there.size(); }

  void weigh_all(std::span<const WeighedBody> bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      weigh(*model, static_cast<int>(b) + 1, bodies[b].mass);
    weigh(*model, palm(), hand.palm_mass);
    for (int k = 0; k < 2; ++k) weigh(*model, finger(k), hand.finger_mass);
    mj_setConst(model.get(), data.get());
  }

  /// Places the open hand at rest.
  void hold_hand(const Eigen::Vector3d& position) const {
    Eigen::Map<Eigen::Vector3d>{hand_position()} = position;
    std::fill_n(hand_position() + 3, 2, 0.5 * hand.max_opening);
    std::fill_n(hand_velocity(), 5, 0.0);
    aim(position);
  }
  void aim(const Eigen::Vector3d& target) const {
    Eigen::Map<Eigen::Vector3d>{data->ctrl} = target;
  }
  /// Each finger's distance from the closed hand.
  void aim_fingers(double target) const { std::fill_n(data->ctrl + 3, 2, target); }
  void show_hand(bool on) {
    hand_is_there = on;
    // It meets bodies and the table, but not itself.
    for (int body = palm(); body <= finger(1); ++body) set_contacts(body, 0, on ? 1 : 0);
    aim_fingers(0.5 * hand.max_opening);
    const double weight = 9.81 * model->body_subtreemass[carriage()];
    data->qfrc_applied[6 * is_there.size() + 2] = weight;
  }
  void step_with_hand() const {
    if (!hand_is_there) hold_hand({0, 0, away});
    step();
  }
  /// Contacts of the present poses.
  void find_contacts() const {
    mj_kinematics(model.get(), data.get());
    mj_comPos(model.get(), data.get());
    mj_collision(model.get(), data.get());
  }
  template <class Visit>
  void for_each_contact(const Visit& visit) const {
    for (int c = 0; c < data->ncon; ++c) {
      const mjContact& contact = data->contact[c];
      if (contact.dist > 0.0) continue;
      const int a = model->geom_bodyid[contact.geom1], b = model->geom_bodyid[contact.geom2];
      visit(a, b, -contact.dist);
      visit(b, a, -contact.dist);
    }
  }
};

GraspWorld::GraspWorld(std::span<const WeighedBody> bodies, const ParallelHand& hand,
                       std::span<const FixedBox> fixed, const GraspWorldOptions& options)
    : implementation_(std::make_unique<Implementation>()) {
  options.validate();
  hand.validate();
  for (const WeighedBody& body : bodies)
    require_option(body.mass > 0.0, "mass", "more than 0", body.mass);
  Implementation& world = *implementation_;
  world.hand = hand;
  world.start(compile_model(describe_world(bodies, hand, fixed, options)), bodies.size());
  world.weigh_all(bodies);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    world.measure_radius(b, *bodies[b].parts);
    world.take_away(b);
  }
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

bool GraspWorld::touches(std::size_t body) const {
  implementation_->find_contacts();
  bool any = false;
  implementation_->for_each_contact(
      [&](int a, int, double) { any = any || a == static_cast<int>(body) + 1; });
  return any;
}

void GraspWorld::show_fixed(bool on) {
  const mjModel& model = *implementation_->model;
  constexpr int first = 1;  // after the table
  for (int g = first; g < model.body_geomnum[0]; ++g) {
    model.geom_contype[g] = on ? 1 : 0;
    model.geom_conaffinity[g] = on ? 1 : 0;
  }
}

void GraspWorld::put_hand(const Eigen::Isometry3d& T_table_tool) {
  Implementation& world = *implementation_;
  world.show_hand(true);
  const Eigen::Quaterniond q(T_table_tool.linear());
  Eigen::Map<Eigen::Vector4d>(world.model->body_quat + 4 * world.palm()) << q.w(), q.x(), q.y(),
      q.z();
  world.hold_hand(T_table_tool.translation());
}

void GraspWorld::take_hand_away() { implementation_->show_hand(false); }

void GraspWorld::pull_hand_to(const Eigen::Vector3d& target_table) {
  implementation_->aim(target_table);
}

void GraspWorld::close_fingers(bool on) {
  implementation_->aim_fingers(on ? -full_force_distance : 0.5 * implementation_->hand.max_opening);
}

double GraspWorld::opening() const {
  const double* position = implementation_->hand_position();
  return position[3] + position[4];
}

Eigen::Isometry3d GraspWorld::hand_pose() const {
  const Implementation& world = *implementation_;
  const double* q = world.model->body_quat + 4 * world.palm();
  Eigen::Isometry3d pose(Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized());
  pose.pretranslate(Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(world.hand_position())));
  return pose;
}

GraspWorld::HandContacts GraspWorld::hand_contacts() const {
  const Implementation& world = *implementation_;
  world.find_contacts();
  HandContacts contacts;
  std::vector<std::array<bool, 3>> touched(size());  // by the palm and by each finger
  std::vector<double> depths(size(), 0.0);
  world.for_each_contact([&](int of_hand, int other, double depth) {
    if (of_hand < world.palm() || other > static_cast<int>(size())) return;
    if (other == 0) {
      contacts.table = true;
      contacts.table_depth = std::max(contacts.table_depth, depth);
      return;
    }
    const auto body = static_cast<std::size_t>(other - 1);
    touched[body][static_cast<std::size_t>(of_hand - world.palm())] = true;
    depths[body] = std::max(depths[body], depth);
  });
  for (std::size_t b = 0; b < size(); ++b) {
    const auto [palm, left, right] = touched[b];
    if (left && right) contacts.held.push_back(b);
    if (!palm && !left && !right) continue;
    contacts.bodies.push_back(b);
    contacts.depths.push_back(depths[b]);
  }
  return contacts;
}

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
GraspWorld::HandContacts GraspWorld::hand_contacts() const { return {}; }
void GraspWorld::advance(double) {}

}  // namespace symscene

#endif
