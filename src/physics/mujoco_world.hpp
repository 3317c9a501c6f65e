#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>
#include <Eigen/Geometry>

#include "symscene/physics/convex_parts.hpp"

// For sources that are compiled with MuJoCo.
namespace symscene {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MujocoModel = std::unique_ptr<mjModel, DeleteModel>;

/// Compiles a world in MJCF. Throws InputError if the meshes cannot be simulated.
MujocoModel compile_model(const std::string& mjcf);

/// The room for contacts of so many bodies with each other and with what is fixed, up to
/// `most_contacts`. MuJoCo fills memory that grows with its square whenever a world is made.
std::string describe_sizes(std::size_t bodies, std::size_t most_contacts);

/// Appends the mesh asset `name` with the hull's vertices to a text in MJCF.
void append_hull(std::string& mjcf, const std::string& name, const Points& vertices);

/// The pose of a position and a unit quaternion (w first) of MuJoCo.
Eigen::Isometry3d pose_of(const double* position, const double* quaternion);

/// Of bodies while they are compiled; then they are weighed. [kg/m³]
constexpr double reference_density = 1000.0;

/// Gives MuJoCo's body this mass, with the distribution that it has.
void weigh(mjModel& model, int body, double mass);

/// A compiled world whose first bodies move freely. Body b is MuJoCo's body b + 1, as 0 is the
/// world itself, with 7 positions and 6 velocities.
struct MujocoWorld {
  double time_step = 0.0;  ///< [s]
  MujocoModel model;
  std::unique_ptr<mjData, DeleteData> data;
  std::vector<bool> is_there;  ///< per free body
  std::vector<double> radius;  ///< about the centre of mass [m]

  double* position(std::size_t body) const { return data->qpos + 7 * body; }
  double* velocity(std::size_t body) const { return data->qvel + 6 * body; }

  /// Takes over the model; no body takes part.
  void start(MujocoModel compiled, std::size_t bodies);
  /// Places a body at rest.
  void hold(std::size_t body, const Eigen::Isometry3d& pose) const;
  /// Whether MuJoCo's body takes part in contacts.
  void set_contacts(int mujoco_body, int contype, int conaffinity) const;
  /// One time step. `control` sets forces once positions and velocities are known. Throws
  /// PhysicsDiverged.
  void step(const std::function<void()>& control = [] {}) const;

  void put(std::size_t body, const Eigen::Isometry3d& pose);
  void take_away(std::size_t body);
  void measure_radius(std::size_t body, const ConvexParts& parts);
  Eigen::Vector3d center_of_mass(std::size_t body) const;
  Eigen::Isometry3d pose(std::size_t body) const;
  /// An upper bound of the speed of any point of the body. [m/s]
  double speed(std::size_t body) const;

 private:
  void hold_away(std::size_t body) const;
  bool diverged() const;
};

}  // namespace symscene
