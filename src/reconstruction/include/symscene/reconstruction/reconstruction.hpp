#pragma once

#include "symscene/core/stage_timer.hpp"
#include "symscene/reconstruction/camera_tracking.hpp"
#include "symscene/reconstruction/keyframes.hpp"
#include "symscene/reconstruction/occupancy_volume.hpp"
#include "symscene/reconstruction/surface_extraction.hpp"

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
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

/// What a pose that is given with a frame is good for.
enum class PoseUse {
  exact,  ///< it is the frame's pose
  start   ///< tracking starts from it
};

/// What became of a frame.
struct FrameReport {
  TrackingResult tracking;   ///< of a frame with an exact pose: converged
  bool fused = false;        ///< the frame is part of the model
  bool relocalized = false;  ///< the camera was lost and has been found
};

/// Turns depth frames into a model of the surface and of the space about it, one frame after the
/// other (section 2.1; KinectFusion, Newcombe et al. 2011): each is aligned with what the model
/// shows from where the camera was, then fused. The first frame that measures enough fixes the
/// world: its camera stands at the origin unless it has a pose. A frame whose pose cannot be found
/// is not fused; the camera is then looked for at its last place and at keyframes that look alike.
///
/// The same frames give the same bits for any number of threads.
class Reconstruction {
 public:
  /// Throws InputError if an option is out of its range.
  explicit Reconstruction(const CameraIntrinsics& camera,
                          const ReconstructionOptions& options = {});

  /// Throws InputError if the image is not of the camera's size.
  FrameReport add(const DepthFrame& frame,
                  const std::optional<Eigen::Isometry3d>& T_world_camera = std::nullopt,
                  PoseUse use = PoseUse::exact);

  const TsdfVolume& volume() const { return volume_; }
  const OccupancyVolume& occupancy() const { return occupancy_; }
  TriangleMesh surface() const { return extract_surface(volume_, options_.surface); }

  /// The model as a camera at a pose would see it.
  ModelView view(const CameraIntrinsics& camera, const Eigen::Isometry3d& T_world_camera) const {
    return cast_model_view(volume_, camera, T_world_camera);
  }

  /// Wall time so far of preparing, tracking, fusing, mapping space and predicting views.
  const std::vector<StageTime>& times() const { return times_; }

 private:
  template <class Body>
  auto timed(std::size_t stage, const Body& body);

  TrackingResult locate(const Measurement& measurement,
                        const std::optional<Eigen::Isometry3d>& guess, bool& relocalized);
  TrackingResult follow(const Measurement& measurement,
                        const std::optional<Eigen::Isometry3d>& guess);
  TrackingResult search(const Measurement& measurement);
  bool agrees(const TrackingResult& result) const;
  ModelView predict(const CameraIntrinsics& camera, const Eigen::Isometry3d& T_world_camera);
  void fuse(const DepthFrame& frame, const Measurement& measurement,
            const Eigen::Isometry3d& T_world_camera);

  CameraIntrinsics camera_;
  ReconstructionOptions options_;
  TsdfVolume volume_;
  OccupancyVolume occupancy_;
  Keyframes keyframes_;
  Eigen::Isometry3d T_world_last_ = Eigen::Isometry3d::Identity();  ///< where the camera was last
  std::optional<ModelView> view_;                             ///< from there, once it is asked for
  Eigen::Isometry3d motion_ = Eigen::Isometry3d::Identity();  ///< of the camera over the last frame
  double disagreement_ =
      0.05;  ///< 1 less the agreement of the frames so far, the last counting most
  bool lost_ = false;
  std::vector<StageTime> times_;
};

}  // namespace symscene
