#ifdef SYMSCENE_HAS_MUJOCO

#include "mujoco_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <mutex>
#include <stdexcept>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "symscene/physics/physics_world.hpp"

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

struct DeleteFiles {
  void operator()(mjVFS* files) const {
    mj_deleteVFS(files);
    delete files;
  }
};

}  // namespace

MujocoModel compile_model(const std::string& mjcf) {
  take_over_errors();
  static std::mutex one_at_a_time;  // the compiler of MuJoCo has global state
  const std::scoped_lock lock(one_at_a_time);
  const std::unique_ptr<mjVFS, DeleteFiles> files(new mjVFS);
  mj_defaultVFS(files.get());
  constexpr const char* name = "world.xml";
  if (mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(mjcf.size())) != 0)
    throw std::runtime_error("out of memory in the physics");
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), name)], mjcf.data(), mjcf.size());
  std::array<char, 1000> error{};
  MujocoModel model(mj_loadXML(name, files.get(), error.data(), static_cast<int>(error.size())));
  mj_freeLastXML();
  if (!model) throw InputError("the meshes", "solids that can be simulated", error.data());
  return model;
}

std::string describe_sizes(std::size_t bodies, std::size_t most_contacts) {
  constexpr std::size_t rows_per_contact = 6;
  const std::size_t contacts = std::min(most_contacts, 100 + 60 * bodies);
  return fmt::format("<size njmax=\"{}\" nconmax=\"{}\"/>\n", rows_per_contact * contacts,
                     contacts);
}

void append_hull(std::string& mjcf, const std::string& name, const Points& vertices) {
  auto out = std::back_inserter(mjcf);
  fmt::format_to(out, "<mesh name=\"{}\" vertex=\"", name);
  for (Eigen::Index i = 0; i < vertices.rows(); ++i)
    fmt::format_to(out, "{} {} {} ", vertices(i, 0), vertices(i, 1), vertices(i, 2));
  mjcf += "\"/>\n";
}

Eigen::Isometry3d pose_of(const double* position, const double* quaternion) {
  const double* q = quaternion;
  Eigen::Isometry3d pose(Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized());
  pose.pretranslate(Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(position)));
  return pose;
}

void weigh(mjModel& model, int body, double mass) {
  const double ratio = mass / model.body_mass[body];
  model.body_mass[body] = mass;
  for (int k = 0; k < 3; ++k) model.body_inertia[3 * body + k] *= ratio;
}

void MujocoWorld::start(MujocoModel compiled, std::size_t bodies) {
  model = std::move(compiled);
  time_step = model->opt.timestep;
  data.reset(mj_makeData(model.get()));
  if (!data) throw std::runtime_error("out of memory in the physics");
  is_there.assign(bodies, false);
  radius.assign(bodies, 0.0);
  for (std::size_t b = 0; b < bodies; ++b) take_away(b);
}

void MujocoWorld::hold(std::size_t body, const Eigen::Isometry3d& pose) const {
  const Eigen::Quaterniond q(pose.linear());
  Eigen::Map<Eigen::Vector3d>(position(body)) = pose.translation();
  Eigen::Map<Eigen::Vector4d>(position(body) + 3) << q.w(), q.x(), q.y(), q.z();
  std::fill_n(velocity(body), 6, 0.0);
}

/// Bodies that are taken away stay far from the table and from each other.
void MujocoWorld::hold_away(std::size_t body) const {
  hold(body,
       Eigen::Isometry3d(Eigen::Translation3d(1e3 + 10.0 * static_cast<double>(body), 0, 1e3)));
}

void MujocoWorld::set_contacts(int mujoco_body, int contype, int conaffinity) const {
  const int first = model->body_geomadr[mujoco_body];
  for (int g = first; g < first + model->body_geomnum[mujoco_body]; ++g) {
    model->geom_contype[g] = contype;
    model->geom_conaffinity[g] = conaffinity;
  }
}

bool MujocoWorld::diverged() const {
  return data->warning[mjWARN_BADQPOS].number + data->warning[mjWARN_BADQVEL].number +
             data->warning[mjWARN_BADQACC].number >
         0;
}

void MujocoWorld::step(const std::function<void()>& control) const {
  for (std::size_t b = 0; b < is_there.size(); ++b) {
    if (!is_there[b]) hold_away(b);
  }
  mj_step1(model.get(), data.get());
  control();
  mj_step2(model.get(), data.get());
  if (diverged()) throw PhysicsDiverged();
}

void MujocoWorld::put(std::size_t body, const Eigen::Isometry3d& pose) {
  is_there[body] = true;
  set_contacts(static_cast<int>(body) + 1, 1, 1);
  hold(body, pose);
}

void MujocoWorld::take_away(std::size_t body) {
  is_there[body] = false;
  set_contacts(static_cast<int>(body) + 1, 0, 0);
  hold_away(body);
}

void MujocoWorld::measure_radius(std::size_t body, const ConvexParts& parts) {
  double squared = 0.0;
  const Eigen::RowVector3f center = center_of_mass(body).cast<float>().transpose();
  for (const Points& part : parts)
    squared =
        std::max<double>(squared, (part.rowwise() - center).rowwise().squaredNorm().maxCoeff());
  radius[body] = std::sqrt(squared);
}

Eigen::Vector3d MujocoWorld::center_of_mass(std::size_t body) const {
  return Eigen::Map<const Eigen::Vector3d>(model->body_ipos + 3 * (body + 1));
}

Eigen::Isometry3d MujocoWorld::pose(std::size_t body) const {
  return pose_of(position(body), position(body) + 3);
}

double MujocoWorld::speed(std::size_t body) const {
  // MuJoCo has the linear velocity of the body's origin in the world frame, the angular velocity
  // in the body frame.
  const Eigen::Map<const Eigen::Vector3d> linear(velocity(body));
  const Eigen::Map<const Eigen::Vector3d> angular(velocity(body) + 3);
  const Eigen::Vector3d lever = center_of_mass(body);
  const Eigen::Vector3d at_center = linear + pose(body).linear() * angular.cross(lever);
  return at_center.norm() + angular.norm() * radius[body];
}

}  // namespace symscene

#endif
