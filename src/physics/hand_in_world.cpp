#ifdef SYMSCENE_HAS_MUJOCO

#include "hand_in_world.hpp"

#include <algorithm>
#include <array>

#include "symscene/core/error.hpp"
#include "world_description.hpp"

namespace symscene {

void WorldWithHand::require_valid(std::span<const WeighedBody> bodies, const ParallelHand& hand) {
  hand.validate();
  for (const WeighedBody& body : bodies)
    require_option(body.mass > 0.0, "mass", "more than 0", body.mass);
}

void WorldWithHand::begin(MujocoModel compiled, std::span<const WeighedBody> bodies,
                          const ParallelHand& of) {
  hand = of;
  start(std::move(compiled), bodies.size());
  palm = mj_name2id(model.get(), mjOBJ_BODY, "palm");
  const int left = mj_name2id(model.get(), mjOBJ_JOINT, "left");
  finger_position = model->jnt_qposadr[left];
  finger_velocity = model->jnt_dofadr[left];
  finger_actuator = model->nu - 2;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    weigh(*model, static_cast<int>(b) + 1, bodies[b].mass);
  weigh(*model, palm, hand.palm_mass);
  for (int k = 0; k < 2; ++k) weigh(*model, finger(k), hand.finger_mass);
  mj_setConst(model.get(), data.get());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    measure_radius(b, *bodies[b].parts);
    take_away(b);
  }
}

void WorldWithHand::show_hand(bool on) const {
  for (int body = palm; body <= finger(1); ++body) set_contacts(body, 0, on ? 1 : 0);
}

void WorldWithHand::show_fixed(bool on) const {
  constexpr int first = 1;  // after the table
  for (int g = first; g < model->body_geomnum[0]; ++g) {
    model->geom_contype[g] = on ? 1 : 0;
    model->geom_conaffinity[g] = on ? 1 : 0;
  }
}

void WorldWithHand::hold_open() const {
  std::fill_n(data->qpos + finger_position, 2, 0.5 * hand.max_opening);
  std::fill_n(data->qvel + finger_velocity, 2, 0.0);
}

void WorldWithHand::close_fingers(bool on) const {
  std::fill_n(data->ctrl + finger_actuator, 2, on ? closing_control() : 0.5 * hand.max_opening);
}

double WorldWithHand::opening() const {
  return data->qpos[finger_position] + data->qpos[finger_position + 1];
}

void WorldWithHand::find_contacts() const {
  mj_kinematics(model.get(), data.get());
  mj_comPos(model.get(), data.get());
  mj_collision(model.get(), data.get());
}

bool WorldWithHand::touches(std::size_t body) const {
  find_contacts();
  bool any = false;
  for_each_contact([&](int a, int, double) { any = any || a == static_cast<int>(body) + 1; });
  return any;
}

HandContacts WorldWithHand::hand_contacts() const {
  find_contacts();
  HandContacts contacts;
  const std::size_t bodies = is_there.size();
  std::vector<std::array<bool, 3>> touched(bodies);  // by the palm and by each finger
  std::vector<double> depths(bodies, 0.0);
  for_each_contact([&](int of_hand, int other, double depth) {
    if (of_hand < palm || of_hand > finger(1) || other > static_cast<int>(bodies)) return;
    if (other == 0) {
      contacts.table = true;
      contacts.table_depth = std::max(contacts.table_depth, depth);
      return;
    }
    const auto body = static_cast<std::size_t>(other - 1);
    touched[body][static_cast<std::size_t>(of_hand - palm)] = true;
    depths[body] = std::max(depths[body], depth);
  });
  for (std::size_t b = 0; b < bodies; ++b) {
    const auto [by_palm, left, right] = touched[b];
    if (left && right) contacts.held.push_back(b);
    if (!by_palm && !left && !right) continue;
    contacts.bodies.push_back(b);
    contacts.depths.push_back(depths[b]);
  }
  return contacts;
}

}  // namespace symscene

#endif
