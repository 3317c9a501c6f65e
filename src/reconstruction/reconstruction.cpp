#include "symscene/reconstruction/reconstruction.hpp"

#include <fmt/format.h>

#include "camera_tracker.hpp"
#include "range_options.hpp"
#include "reconstruction/surface_extraction.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

TrackingResult known_pose(const Eigen::Isometry3d& T_world_camera) {
  TrackingResult result;
  result.status = TrackingStatus::converged;
  result.T_world_camera = T_world_camera;
  result.overlap = result.inliers = 1.0;
  return result;
}

/// The pose of the frame that defines the world.
TrackingResult first_pose(const Measurement& measurement,
                          const std::optional<Eigen::Isometry3d>& guess,
                          const TrackingOptions& options) {
  TrackingResult first = known_pose(guess.value_or(Eigen::Isometry3d::Identity()));
  if (measures_enough(measurement, options)) return first;
  first.status = TrackingStatus::lost;
  first.searchable = false;
  first.reason = "too little of the image is measured";
  return first;
}

void require_pose(const Eigen::Isometry3d& T_world_camera) {
  const Eigen::Matrix3d R = T_world_camera.linear();
  const bool rigid = (R * R.transpose()).isIdentity(1e-4) && R.determinant() > 0.0;
  if (T_world_camera.matrix().allFinite() && rigid && T_world_camera.translation().norm() < 1e5) {
    return;
  }
  throw InputError("camera's pose", "a rotation and a translation within 100 km", "another matrix");
}

ReconstructionOptions validated(const ReconstructionOptions& options) {
  options.validate();
  return options;
}

}  // namespace

struct Reconstruction::Implementation {
  Implementation(const CameraIntrinsics& given, const ReconstructionOptions& chosen)
      : camera(given),
        options(validated(chosen)),
        volume(options.tsdf, options.measurement),
        occupancy(options.occupancy),
        tracker(volume, options.tracking, options.measurement, clock) {}

  TrackingResult locate(const Measurement& measurement,
                        const std::optional<Eigen::Isometry3d>& T_world_camera, PoseUse use,
                        bool& relocalized) {
    TrackingResult result;
    if (T_world_camera && use == PoseUse::exact) {
      result = known_pose(*T_world_camera);
    } else if (volume.empty()) {
      result = first_pose(measurement, T_world_camera, options.tracking);
    } else {
      auto located = tracker.locate(measurement, T_world_camera, use == PoseUse::prior);
      result = std::move(located.tracking);
      relocalized = located.relocalized;
    }
    if (result.status != TrackingStatus::lost && !volume.in_reach(result.T_world_camera)) {
      result.status = TrackingStatus::lost;
      result.reason = "the camera is too far from the model's origin";
    }
    return result;
  }

  /// Chooses the resolution of the model by its first frame.
  void begin(const Measurement& measurement) {
    options = fitted_to_depth(options, near_depth(measurement));
    volume = TsdfVolume(options.tsdf, options.measurement);
    occupancy = OccupancyVolume(options.occupancy);
  }

  void fuse(const DepthFrame& frame, const Measurement& measurement,
            const Eigen::Isometry3d& T_world_camera) {
    clock.time(StageClock::fuse, [&] { volume.integrate(measurement, T_world_camera); });
    clock.time(StageClock::map_space, [&] { occupancy.integrate(frame, camera, T_world_camera); });
  }

  CameraIntrinsics camera;
  ReconstructionOptions options;
  TsdfVolume volume;
  OccupancyVolume occupancy;
  StageClock clock;
  CameraTracker tracker;
};

Reconstruction::Reconstruction(const CameraIntrinsics& camera, const ReconstructionOptions& options)
    : implementation_(std::make_unique<Implementation>(camera, options)) {}
Reconstruction::~Reconstruction() = default;
Reconstruction::Reconstruction(Reconstruction&&) noexcept = default;
Reconstruction& Reconstruction::operator=(Reconstruction&&) noexcept = default;

FrameReport Reconstruction::add(const DepthFrame& frame,
                                const std::optional<Eigen::Isometry3d>& T_world_camera,
                                PoseUse use) {
  if (T_world_camera) require_pose(*T_world_camera);
  Implementation& model = *implementation_;
  const Measurement measurement = model.clock.time(StageClock::prepare, [&] {
    return prepare_measurement(frame, model.camera, model.options.measurement);
  });
  FrameReport report;
  report.tracking = model.locate(measurement, T_world_camera, use, report.relocalized);
  if (report.tracking.status == TrackingStatus::lost) {
    model.tracker.lose();
    return report;
  }
  const bool confirmed = !model.volume.empty() && !report.relocalized &&
                         report.tracking.status == TrackingStatus::converged;
  if (model.volume.empty()) model.begin(measurement);
  model.fuse(frame, measurement, report.tracking.T_world_camera);
  model.tracker.accept(measurement, report.tracking, confirmed);
  report.fused = true;
  return report;
}

bool Reconstruction::empty() const { return implementation_->volume.empty(); }

TriangleMesh Reconstruction::surface() const { return surface(implementation_->options.surface); }

TriangleMesh Reconstruction::surface(const SurfaceExtractionOptions& options) const {
  return extract_surface(implementation_->volume, options);
}

const OccupancyVolume& Reconstruction::occupancy() const { return implementation_->occupancy; }

double Reconstruction::voxel_size() const { return implementation_->volume.voxel_size(); }

std::vector<std::string> Reconstruction::warnings() const {
  if (!implementation_->volume.is_full()) return {};
  return {fmt::format(
      "the surface has reached {:.3g} GB and was not extended after that: larger voxels "
      "(tsdf.voxel_size), a smaller range (measurement.max_depth) or more memory "
      "(tsdf.max_memory) hold more",
      implementation_->options.tsdf.max_memory)};
}

std::size_t Reconstruction::bytes() const {
  return implementation_->volume.bytes() + implementation_->occupancy.memory();
}

const std::vector<StageTime>& Reconstruction::times() const {
  return implementation_->clock.times();
}

}  // namespace symscene
