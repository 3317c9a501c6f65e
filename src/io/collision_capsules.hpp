#pragma once

#include <vector>

#include "symscene/robots/robot_model.hpp"

namespace symscene {

enum class CollisionKind : std::uint8_t { sphere, cylinder, box };

/// A shape of a link, centred in its own frame.
struct CollisionShape {
  CollisionKind kind = CollisionKind::sphere;
  Eigen::Isometry3d T_link_shape = Eigen::Isometry3d::Identity();
  /// A sphere's radius; a cylinder's radius and length along z; a box's edges. [m]
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
};

/// Capsules in the link's frame that contain the shapes. A cylinder becomes one of its radius and
/// its length; spheres of its radius that are centred at its ends are part of it.
std::vector<Capsule> collision_capsules(const std::vector<CollisionShape>& shapes);

}  // namespace symscene
