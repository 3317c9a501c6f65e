#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "core/rigid_motion.hpp"

namespace symscene {

/// A closed box that stands on z = 0, centred about the z axis; its faces are cut into a grid with
/// cells of at most `max_edge`. [m]
TriangleMesh make_box(const Eigen::Vector3d& size, double max_edge);

/// A corner of a profile: distance from the z axis and height. [m]
struct ProfilePoint {
  double radius = 0.0;
  double height = 0.0;
};

/// The closed surface that a profile sweeps about the z axis. The profile starts and ends on the
/// axis and has the outside on its right: for a solid from its bottom up to its top, for a cup on
/// over the rim and down the inside. Its lines are cut into steps of at most `max_edge`. [m]
TriangleMesh make_revolution(std::span<const ProfilePoint> profile, int segments, double max_edge);

/// A part of a mirrored body.
struct Ellipsoid {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d radii = Eigen::Vector3d::Ones();   ///< [m]
};

/// The smooth union of ellipsoids and of their mirror images in y = 0, cut off flat below z = 0.
/// One half is meshed by marching tetrahedra and mirrored, so that the mesh is its own reflection
/// to the last bit. `blend` is the width over which parts blend, `cell` the edge of
/// the grid. [m]
TriangleMesh make_mirrored_body(std::span<const Ellipsoid> parts, double blend, double cell);

/// The centre of mass of a closed mesh of uniform density. [m]
Eigen::Vector3d volume_centroid(const TriangleMesh& mesh);

/// Whether a point is inside a closed mesh, by its winding number (Jacobson et al. 2013).
bool is_inside(const TriangleMesh& mesh, const Eigen::Vector3d& point);

}  // namespace symscene
