#pragma once

#include <memory>
#include <span>

#include <Eigen/Geometry>

#include "symscene/physics/convex_parts.hpp"

namespace symscene {

/// Rigid bodies over a table, z = 0, that is endless. Bodies are away until they are put somewhere.
class PhysicsWorld {
 public:
  /// Throws InputError if the bodies cannot be simulated.
  explicit PhysicsWorld(std::span<const ConvexParts* const> bodies);
  ~PhysicsWorld();
  PhysicsWorld(const PhysicsWorld&) = delete;
  PhysicsWorld& operator=(const PhysicsWorld&) = delete;

  void put(std::size_t body, const Eigen::Isometry3d& T_table_body);
  void take_away(std::size_t body);
  bool is_there(std::size_t body) const;

  /// Throws std::runtime_error if the simulation diverges.
  void advance(double seconds);

  Eigen::Isometry3d pose(std::size_t body) const;
  /// Of its fastest point, at most. [m/s]
  double speed(std::size_t body) const;
  /// How far a body is inside others or the table, at most. [m]
  double penetration(std::size_t body) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
