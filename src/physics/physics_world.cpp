#include "symscene/physics/physics_world.hpp"

#ifdef SYMSCENE_HAS_MUJOCO

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "mujoco_world.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

std::string describe_options(std::size_t bodies, const PhysicsOptions& options) {
  constexpr std::size_t most_contacts = 670;
  return fmt::format(R"(<mujoco>
<compiler boundmass="0.005" boundinertia="1e-7"/>
{}<option timestep="{}" cone="elliptic" impratio="5"><flag multiccd="enable"/></option>
<default><geom condim="6" friction="{} {} {}" density="{}"
  solref="0.006 1" solimp="0.95 0.99 0.001"/></default>
)",
                     describe_sizes(bodies, most_contacts), options.time_step,
                     options.sliding_friction, options.torsional_friction, options.rolling_friction,
                     options.density);
}

/// The world in MJCF. MuJoCo numbers the bodies from 1: 0 is the table.
std::string describe_world(std::span<const ConvexParts* const> bodies,
                           const PhysicsOptions& options) {
  std::string text = describe_options(bodies.size(), options) + "<asset>\n";
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t p = 0; p < bodies[b]->size(); ++p)
      append_hull(text, fmt::format("{}_{}", b, p), (*bodies[b])[p]);
  }
  text += "</asset>\n<worldbody><geom type=\"plane\" size=\"0 0 1\"/>\n";
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    text += "<body><freejoint/>";
    for (std::size_t p = 0; p < bodies[b]->size(); ++p)
      text += fmt::format("<geom type=\"mesh\" mesh=\"{}_{}\"/>", b, p);
    text += "</body>\n";
  }
  return text + "</worldbody></mujoco>\n";
}

}  // namespace

struct PhysicsWorld::Implementation : MujocoWorld {};

PhysicsWorld::PhysicsWorld(std::span<const ConvexParts* const> bodies,
                           const PhysicsOptions& options)
    : implementation_(std::make_unique<Implementation>()) {
  options.validate();
  implementation_->start(compile_model(describe_world(bodies, options)), bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) implementation_->measure_radius(b, *bodies[b]);
}

PhysicsWorld::~PhysicsWorld() = default;

void PhysicsWorld::put(std::size_t body, const Eigen::Isometry3d& T_table_body) {
  implementation_->put(body, T_table_body);
}

void PhysicsWorld::take_away(std::size_t body) { implementation_->take_away(body); }

bool PhysicsWorld::is_there(std::size_t body) const { return implementation_->is_there[body]; }

void PhysicsWorld::advance(double seconds) {
  const auto steps = std::lround(seconds / implementation_->time_step);
  for (long step = 0; step < steps; ++step) implementation_->step();
}

Eigen::Isometry3d PhysicsWorld::pose(std::size_t body) const { return implementation_->pose(body); }

double PhysicsWorld::speed(std::size_t body) const { return implementation_->speed(body); }

double PhysicsWorld::penetration(std::size_t body) const {
  const MujocoWorld& world = *implementation_;
  double deepest = 0.0;
  for (int c = 0; c < world.data->ncon; ++c) {
    const mjContact& contact = world.data->contact[c];
    for (const int geom : {contact.geom1, contact.geom2}) {
      if (world.model->geom_bodyid[geom] == static_cast<int>(body) + 1)
        deepest = std::max(deepest, -contact.dist);
    }
  }
  return deepest;
}

bool has_physics() { return true; }

}  // namespace symscene

#else

#include "symscene/core/error.hpp"

namespace symscene {

bool has_physics() { return false; }

struct PhysicsWorld::Implementation {};
PhysicsWorld::PhysicsWorld(std::span<const ConvexParts* const>, const PhysicsOptions&) {
  throw InputError("this build of SymScene",
                   "physics (the package libmujoco-dev, then configure and build again)", "none");
}
PhysicsWorld::~PhysicsWorld() = default;
void PhysicsWorld::put(std::size_t, const Eigen::Isometry3d&) {}
void PhysicsWorld::take_away(std::size_t) {}
bool PhysicsWorld::is_there(std::size_t) const { return false; }
void PhysicsWorld::advance(double) {}
Eigen::Isometry3d PhysicsWorld::pose(std::size_t) const { return Eigen::Isometry3d::Identity(); }
double PhysicsWorld::speed(std::size_t) const { return 0.0; }
double PhysicsWorld::penetration(std::size_t) const { return 0.0; }

}  // namespace symscene

#endif
