#pragma once

#include <string>

#include "symscene/core/triangle_mesh.hpp"
#include "symscene/ground_truth/scene_truth.hpp"

namespace symscene {

/// The symmetries of a whole surface as ground truth, in the frame of the surface:
/// find_symmetry_group() on all of it. Axes are those of any turn. Strict are those that move the
/// surface by at most 0.008 of its diagonal on average, as those of scanned meshes are; a plane
/// across a continuous axis is weak, as that of a simulated can is. Of a sphere none is listed.
TrueObject true_symmetries(const std::string& name, const TriangleMesh& surface);

/// The ground truth of the same surface, scaled about the origin of its frame and then moved by
/// T_world_object.
TrueObject placed(TrueObject object, double scale, const Eigen::Isometry3d& T_world_object);

}  // namespace symscene
