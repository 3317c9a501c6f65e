#include "symscene/physics/physics_world.hpp"

#ifdef SYMSCENE_HAS_MUJOCO

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// MuJoCo's own handlers write a file and end the process. Its error handler must not return.
/// Divergence, the one warning that matters here, is read from mjData.
void take_over_errors() {
  static std::once_flag once;
  std::call_once(once, [] {
    mju_user_error = [](const char* message) {
      throw std::runtime_error(fmt::format("the physics failed: {}", message));
    };
    mju_user_warning = [](const char*) {};
  });
}

std::string describe_options(const PhysicsOptions& options) {
  return fmt::format(R"(<mujoco>
<compiler boundmass="0.005" boundinertia="1e-7"/>
<size njmax="4000" nconmax="700"/>
<option timestep="{}" cone="elliptic" impratio="5"><flag multiccd="enable"/></option>
<default><geom condim="6" friction="{} {} {}" density="{}"
  solref="0.006 1" solimp="0.95 0.99 0.001"/></default>
)",
                     options.time_step, options.sliding_friction, options.torsional_friction,
                     options.rolling_friction, options.density);
}

void append_hull(std::string& text, std::size_t body, std::size_t part, const Points& points) {
  auto out = std::back_inserter(text);
  fmt::format_to(out, "<mesh name=\"{}_{}\" vertex=\"", body, part);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    fmt::format_to(out, "{} {} {} ", points(i, 0), points(i, 1), points(i, 2));
  text += "\"/>\n";
}

/// The world in MJCF. MuJoCo numbers the bodies from 1: 0 is the table.
std::string describe_world(std::span<const ConvexParts* const> bodies,
                           const PhysicsOptions& options) {
  std::string text = describe_options(options) + "<asset>\n";
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t p = 0; p < bodies[b]->size(); ++p) append_hull(text, b, p, (*bodies[b])[p]);
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

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
struct DeleteFiles {
  void operator()(mjVFS* files) const {
    mj_deleteVFS(files);
    delete files;
  }
};
using Model = std::unique_ptr<mjModel, DeleteModel>;

Model compile_world(const std::string& text) {
  static std::mutex one_at_a_time;  // the compiler of MuJoCo has global state
  const std::scoped_lock lock(one_at_a_time);
  const std::unique_ptr<mjVFS, DeleteFiles> files(new mjVFS);
  mj_defaultVFS(files.get());
  constexpr const char* name = "world.xml";
  if (mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(text.size())) != 0)
    throw std::runtime_error("out of memory in the physics");
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), name)], text.data(), text.size());
  std::array<char, 1000> error{};
  Model model(mj_loadXML(name, files.get(), error.data(), static_cast<int>(error.size())));
  mj_freeLastXML();
  if (!model) throw InputError("the meshes", "solids that can be simulated", error.data());
  return model;
}

}  // namespace

struct PhysicsWorld::Implementation {
  double time_step = 0.0;  ///< [s]
  Model model;
  std::unique_ptr<mjData, DeleteData> data;
  std::vector<bool> is_there;
  std::vector<double> radius;  ///< about the centre of mass [m]

  double* position(std::size_t body) const { return data->qpos + 7 * body; }
  double* velocity(std::size_t body) const { return data->qvel + 6 * body; }

  void hold(std::size_t body, const Eigen::Isometry3d& pose) const {
    const Eigen::Quaterniond q(pose.linear());
    Eigen::Map<Eigen::Vector3d>(position(body)) = pose.translation();
    Eigen::Map<Eigen::Vector4d>(position(body) + 3) << q.w(), q.x(), q.y(), q.z();
    std::fill_n(velocity(body), 6, 0.0);
  }

  /// Bodies that are taken away stay far from the table and from each other.
  void hold_away(std::size_t body) const {
    hold(body,
         Eigen::Isometry3d(Eigen::Translation3d(1e3 + 10.0 * static_cast<double>(body), 0, 1e3)));
  }

  void set_contacts(std::size_t body, bool on) {
    is_there[body] = on;
    const int first = model->body_geomadr[body + 1];
    for (int g = first; g < first + model->body_geomnum[body + 1]; ++g) {
      model->geom_contype[g] = on ? 1 : 0;
      model->geom_conaffinity[g] = on ? 1 : 0;
    }
  }

  Eigen::Vector3d center_of_mass(std::size_t body) const {
    return Eigen::Map<const Eigen::Vector3d>(model->body_ipos + 3 * (body + 1));
  }

  bool diverged() const {
    return data->warning[mjWARN_BADQPOS].number + data->warning[mjWARN_BADQVEL].number +
               data->warning[mjWARN_BADQACC].number >
           0;
  }
};

PhysicsWorld::PhysicsWorld(std::span<const ConvexParts* const> bodies,
                           const PhysicsOptions& options)
    : implementation_(std::make_unique<Implementation>()) {
  options.validate();
  take_over_errors();
  Implementation& world = *implementation_;
  world.time_step = options.time_step;
  world.model = compile_world(describe_world(bodies, options));
  world.data.reset(mj_makeData(world.model.get()));
  if (!world.data) throw std::runtime_error("out of memory in the physics");
  world.is_there.assign(bodies.size(), false);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    double squared = 0.0;
    const Eigen::RowVector3f center = world.center_of_mass(b).cast<float>().transpose();
    for (const Points& part : *bodies[b])
      squared =
          std::max<double>(squared, (part.rowwise() - center).rowwise().squaredNorm().maxCoeff());
    world.radius.push_back(std::sqrt(squared));
    take_away(b);
  }
}

PhysicsWorld::~PhysicsWorld() = default;

void PhysicsWorld::put(std::size_t body, const Eigen::Isometry3d& T_table_body) {
  implementation_->set_contacts(body, true);
  implementation_->hold(body, T_table_body);
}

void PhysicsWorld::take_away(std::size_t body) {
  implementation_->set_contacts(body, false);
  implementation_->hold_away(body);
}

bool PhysicsWorld::is_there(std::size_t body) const { return implementation_->is_there[body]; }

void PhysicsWorld::advance(double seconds) {
  Implementation& world = *implementation_;
  const auto steps = std::lround(seconds / world.time_step);
  for (long step = 0; step < steps; ++step) {
    for (std::size_t b = 0; b < world.is_there.size(); ++b) {
      if (!world.is_there[b]) world.hold_away(b);
    }
    mj_step(world.model.get(), world.data.get());
    if (world.diverged()) throw PhysicsDiverged();
  }
}

Eigen::Isometry3d PhysicsWorld::pose(std::size_t body) const {
  const double* p = implementation_->position(body);
  Eigen::Isometry3d pose(Eigen::Quaterniond(p[3], p[4], p[5], p[6]).normalized());
  pose.pretranslate(Eigen::Vector3d(p[0], p[1], p[2]));
  return pose;
}

double PhysicsWorld::speed(std::size_t body) const {
  // MuJoCo has the linear velocity of the body's origin in the world frame, the angular velocity
  // in the body frame.
  const Eigen::Map<const Eigen::Vector3d> linear(implementation_->velocity(body));
  const Eigen::Map<const Eigen::Vector3d> angular(implementation_->velocity(body) + 3);
  const Eigen::Vector3d lever = implementation_->center_of_mass(body);
  const Eigen::Vector3d at_center = linear + pose(body).linear() * angular.cross(lever);
  return at_center.norm() + angular.norm() * implementation_->radius[body];
}

double PhysicsWorld::penetration(std::size_t body) const {
  const Implementation& world = *implementation_;
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
