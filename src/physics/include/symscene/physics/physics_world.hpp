#pragma once

#include <memory>
#include <span>
#include <stdexcept>

#include <Eigen/Geometry>

#include "symscene/core/options.hpp"
#include "symscene/physics/convex_parts.hpp"

namespace symscene {

/// Whether this build has physics (MuJoCo). Without it a PhysicsWorld cannot be constructed.
bool has_physics();

/// Contacts have elliptic friction cones against sliding, torsion and rolling, so that bodies come
/// to rest. All bodies and the table are of one material.
struct PhysicsOptions {
  double time_step = 0.002;
  double density = 400.0;
  double sliding_friction = 0.7;
  double torsional_friction = 0.005;
  double rolling_friction = 0.001;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("time_step", self.time_step, "s", between(1e-5, 0.01), "step of the integration");
    visit("density", self.density, "kg/m^3", above(0.0), "density of the bodies");
    visit("sliding_friction", self.sliding_friction, "", above(0.0),
          "coefficient of friction against sliding");
    visit("torsional_friction", self.torsional_friction, "m", above(0.0),
          "coefficient of friction against turning about the contact normal");
    visit("rolling_friction", self.rolling_friction, "m", above(0.0),
          "coefficient of friction against rolling");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// The simulation left the range of finite numbers: other initial poses may not.
struct PhysicsDiverged : std::runtime_error {
  PhysicsDiverged() : std::runtime_error("the physics diverged") {}
};

/// Rigid bodies above a table. The world is the table's frame: the table is the unbounded plane
/// z = 0, z points up, gravity acts along -z with 9.81 m/s². Bodies are numbered from 0 in the
/// order in which they are given; a body takes part only between put() and take_away(). All lengths
/// are in metres. The same calls give the same poses to the last bit.
class PhysicsWorld {
 public:
  /// `bodies` has the convex parts of each body in the body's frame (convex_parts()). They are
  /// copied. Throws InputError if an option is out of its range, the bodies cannot be simulated, or
  /// this build has no physics.
  explicit PhysicsWorld(std::span<const ConvexParts* const> bodies,
                        const PhysicsOptions& options = {});
  ~PhysicsWorld();
  PhysicsWorld(const PhysicsWorld&) = delete;
  PhysicsWorld& operator=(const PhysicsWorld&) = delete;

  /// Puts the body at a pose, at rest; it may be in the world already.
  void put(std::size_t body, const Eigen::Isometry3d& T_table_body);
  /// Removes the body from the world until it is put back.
  void take_away(std::size_t body);
  /// Whether the body takes part.
  bool is_there(std::size_t body) const;

  /// Simulates `seconds`, rounded to whole time steps. Throws PhysicsDiverged if the
  /// simulation diverges.
  void advance(double seconds);

  /// T_table_body.
  Eigen::Isometry3d pose(std::size_t body) const;
  /// An upper bound of the speed of any point of the body. [m/s]
  double speed(std::size_t body) const;
  /// The depth to which the body penetrates other bodies or the table, at most. [m]
  double penetration(std::size_t body) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
