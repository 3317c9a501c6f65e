#pragma once

#include <span>

#include <Eigen/Geometry>

#include "symscene/core/options.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

struct TruthTransferOptions {
  double tolerance = 0.008;     ///< farthest that a point may be from the surface it shows [m]
  int min_object_points = 100;  ///< at 5 mm; the truth leaves out what shows fewer

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("tolerance", self.tolerance, "m", "farthest that a point may be from its surface");
    visit("min_object_points", self.min_object_points, "", "points at 5 mm that truth asks for");
  }
  void validate() const;
};

/// The truth in another frame: T_to_truth maps the truth's frame to it.
SceneTruth transformed(SceneTruth truth, const Eigen::Isometry3d& T_to_truth);

/// The rigid transform that maps one list of poses best onto another, pose by pose: the mean
/// rotation and translation between them. Identity where there is none.
/// Throws InputError if there are not as many of one as of the other.
Eigen::Isometry3d align_poses(std::span<const Eigen::Isometry3d> poses_target,
                              std::span<const Eigen::Isometry3d> poses_source);

/// The truth of a scene that was reconstructed from a sequence with truth, in the cloud's frame:
/// each point belongs to the object whose true surface is nearest to it, unless that is too far
/// away or the table is nearer. `meshes` has the mesh of each object in the mesh' own frame;
/// T_cloud_truth maps the truth's frame to the cloud's (align_poses(tracked, true)).
/// Throws InputError if an object has no pose or there are not as many meshes as objects.
SceneTruth transfer_truth(const SceneTruth& truth, std::span<const TriangleMesh> meshes,
                          const PointCloud& cloud, const Eigen::Isometry3d& T_cloud_truth,
                          const TruthTransferOptions& options = {});

/// The meshes of a truth's objects where they stand, in the truth's frame.
/// Throws InputError as transfer_truth() does.
std::vector<TriangleMesh> placed_meshes(const SceneTruth& truth,
                                        std::span<const TriangleMesh> meshes);

}  // namespace symscene
