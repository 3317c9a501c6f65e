#pragma once

#include <memory>
#include <optional>
#include <string>

#include "symscene/core/stage_timer.hpp"
#include "symscene/core/triangle_mesh.hpp"
#include "symscene/reconstruction/measurement_options.hpp"
#include "symscene/reconstruction/occupancy_volume.hpp"
#include "symscene/reconstruction/surface_options.hpp"
#include "symscene/reconstruction/tracking_options.hpp"

namespace symscene {

struct ReconstructionOptions {
  MeasurementOptions measurement;
  TsdfOptions tsdf;
  TrackingOptions tracking;
  OccupancyVolumeOptions occupancy;
  SurfaceExtractionOptions surface;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("measurement", self.measurement);
    visit("tsdf", self.tsdf);
    visit("tracking", self.tracking);
    visit("occupancy", self.occupancy);
    visit("surface", self.surface);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

enum class TrackingStatus {
  converged,   ///< the pose is known
  degenerate,  ///< the pose is known except for motions that the surface does not constrain
  lost         ///< the pose is not known
};

const char* to_string(TrackingStatus status);

/// The outcome of aligning a frame with the model.
struct TrackingResult {
  TrackingStatus status = TrackingStatus::lost;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  double overlap = 0.0;    ///< share of the measured pixels that match the model
  double inliers = 0.0;    ///< share of the matches within three deviations
  double agreement = 0.0;  ///< share of the measured pixels on which the model shows a surface that
                           ///< match it within three deviations
  double residual = 0.0;   ///< root mean square residual of the inliers [m]
  std::vector<std::string> unconstrained;  ///< motions of the camera that are free, if degenerate
  const char* reason = "";                 ///< why the camera is lost
  bool searchable = true;  ///< the image shows enough for relocalization to be worth its time
};

/// How a pose that is given with a frame is used.
enum class PoseUse {
  exact,  ///< it is the frame's pose
  start,  ///< tracking starts from it
  prior   ///< it is known up to tracking.prior_deviation, as a robot's arm knows its camera's: the
          ///< image corrects it only as far as it says more, and no other pose is searched
};

/// The outcome of adding a frame.
struct FrameReport {
  TrackingResult tracking;   ///< converged for a frame with an exact pose
  bool fused = false;        ///< the frame is part of the model
  bool relocalized = false;  ///< the camera was lost and has been found
};

/// Turns depth frames into a model of the surface and of the space around it, frame by frame
/// (section 2.1; KinectFusion, Newcombe et al. 2011): each frame is aligned with the model as seen
/// from the camera's last pose, then fused. The first frame that measures enough defines the world:
/// its camera is at the origin unless it has a pose. A frame whose pose is not found is not fused;
/// the camera is then searched at its last pose and at similar keyframes.
///
/// The same frames give the same bits for any number of threads.
class Reconstruction {
 public:
  /// Throws InputError if an option is out of its range.
  explicit Reconstruction(const CameraIntrinsics& camera,
                          const ReconstructionOptions& options = {});
  ~Reconstruction();
  Reconstruction(Reconstruction&&) noexcept;
  Reconstruction& operator=(Reconstruction&&) noexcept;

  /// Locates a frame and fuses it. Throws InputError if the image is not of the camera's size or
  /// the pose is not rigid.
  FrameReport add(const DepthFrame& frame,
                  const std::optional<Eigen::Isometry3d>& T_world_camera = std::nullopt,
                  PoseUse use = PoseUse::exact);

  /// Whether no frame has been fused.
  bool empty() const;

  /// The surface by marching cubes (Lorensen and Cline 1987), in the world's frame, with the
  /// options of the reconstruction or others.
  TriangleMesh surface() const;
  TriangleMesh surface(const SurfaceExtractionOptions& options) const;

  /// The free, occupied and unseen space.
  const OccupancyVolume& occupancy() const;

  /// Edge of a voxel of the surface: with the first frame, that of tsdf.voxel_sigmas. [m]
  double voxel_size() const;

  /// Sentences for the user: that the surface has reached its largest memory.
  std::vector<std::string> warnings() const;

  /// Memory of the model. [bytes]
  std::size_t bytes() const;

  /// Wall time so far of preparing, tracking, fusing, mapping space and predicting views.
  const std::vector<StageTime>& times() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
