#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/triangle_mesh.hpp"
#include "symscene/ground_truth/scene_truth.hpp"
#include "symscene/simulation/sensor_frame.hpp"

namespace symscene {

struct TruthTransferOptions {
  double tolerance = 0.008;
  int min_object_points = 100;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("tolerance", self.tolerance, "m", above(0.0),
          "largest distance of a point from the true surface of its object, or from the depth of a "
          "labelled view");
    visit("min_object_points", self.min_object_points, "", at_least(1),
          "least points at 5 mm of an object in the ground truth");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// The ground truth in another frame. T_to_truth maps the frame of `truth` to it.
SceneTruth transformed(SceneTruth truth, const Eigen::Isometry3d& T_to_truth);

/// The rigid transform T_target_source that best maps one list of poses onto another, pose by pose:
/// the mean rotation and translation between them. Identity for empty lists. Throws InputError if
/// the lists differ in length.
Eigen::Isometry3d align_poses(std::span<const Eigen::Isometry3d> poses_target,
                              std::span<const Eigen::Isometry3d> poses_source);

/// The ground truth of a scene that was reconstructed from a sequence with ground truth, in the
/// frame of the cloud: each point belongs to the object whose true surface is nearest to it, unless
/// that is too far away or the table is nearer. `meshes` has the mesh of each object in the frame
/// of the mesh; T_cloud_truth maps the frame of `truth` to that of the cloud (align_poses(tracked,
/// true)). Throws InputError if an object has no pose, the numbers of meshes and objects differ, or
/// an option is out of range.
SceneTruth transfer_truth(const SceneTruth& truth, std::span<const TriangleMesh> meshes,
                          const PointCloud& cloud, const Eigen::Isometry3d& T_cloud_truth,
                          const TruthTransferOptions& options = {});

/// The ground truth of the points of a single image, in the frame of its camera: each point belongs
/// to the object that its pixel shows, wherever the error of the sensor moves it, as in a labelled
/// image of a real camera; in a hole, to that at the border. `truth` is in the frame of `frame`'s
/// pose. Throws InputError if the image is not of the camera's size or an option is out of range.
SceneTruth view_truth(const SceneTruth& truth, const SensorFrame& frame,
                      const CameraIntrinsics& camera, const PointCloud& cloud_camera,
                      const TruthTransferOptions& options = {});

/// What a frame of a sweep shows of a reconstructed cloud.
struct LabelledView {
  Eigen::Isometry3d T_camera_cloud = Eigen::Isometry3d::Identity();
  std::vector<float> depth;    ///< as measured, 0 for none [m]
  std::vector<Index> objects;  ///< as in SensorFrame
};

/// Views of one camera.
struct LabelledSweep {
  CameraIntrinsics camera;
  std::vector<LabelledView> views;
};

/// The ground truth of a cloud that was reconstructed from views: each point belongs to the object
/// that most views which measured it show there, wherever the errors of the sensor move it. A view
/// measured a point if the depths differ by at most the tolerance, which grows with the square of
/// the depth beyond 1 m. `truth` is mapped by T_cloud_truth. Throws InputError if an image is not
/// of the camera's size or an option is out of range.
SceneTruth sweep_truth(const SceneTruth& truth, const LabelledSweep& sweep, const PointCloud& cloud,
                       const Eigen::Isometry3d& T_cloud_truth,
                       const TruthTransferOptions& options = {});

/// The meshes of the objects at their poses, in the frame of `truth`.
/// Throws InputError as transfer_truth() does.
std::vector<TriangleMesh> placed_meshes(const SceneTruth& truth,
                                        std::span<const TriangleMesh> meshes);

}  // namespace symscene
