#include "sweep_stitching.hpp"

#include <fmt/format.h>

#include "core/median.hpp"
#include "core/rigid_motion.hpp"

namespace symscene::app {
namespace {

/// The median rotation from one placed frame to the next of the sequence. [rad]
double median_rotation(const PlacedFrames& placed) {
  std::vector<double> angles;
  for (std::size_t k = 1; k < placed.frames.size(); ++k) {
    if (placed.frames[k] != placed.frames[k - 1] + 1) continue;
    const Eigen::Isometry3d T =
        placed.trajectory[k - 1].T_world_camera.inverse() * placed.trajectory[k].T_world_camera;
    angles.push_back(Eigen::AngleAxisd(T.linear()).angle());
  }
  return median(std::move(angles)).value_or(0.0);
}

/// The frames that can be read; tracking has named the others.
ReadFrames read_all(const DepthSequence& sequence) {
  ReadFrames read;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    try {
      read.frames.push_back(sequence.read(i));
      read.numbers.push_back(i);
    } catch (const InputError&) {
    }
  }
  return read;
}

}  // namespace

PlacedFrames placed_frames(const StitchingResult& stitched, const ReadFrames& read) {
  PlacedFrames placed;
  for (std::size_t k = 0; k < read.frames.size(); ++k) {
    if (!stitched.frames[k].T_world_camera) continue;
    placed.trajectory.push_back({read.frames[k].time, *stitched.frames[k].T_world_camera});
    placed.frames.push_back(read.numbers[k]);
  }
  return placed;
}

Reconstruction fuse_placed(const StitchingResult& stitched, const ReadFrames& read,
                           const CameraIntrinsics& camera, const ReconstructionOptions& options) {
  Reconstruction reconstruction(camera, options);
  for (std::size_t k = 0; k < read.frames.size(); ++k) {
    const auto& pose = stitched.frames[k].T_world_camera;
    if (pose) reconstruction.add(read.frames[k], *pose, PoseUse::exact);
  }
  return reconstruction;
}

std::string reason_to_stitch(const DepthSequence& sequence, const PlacedSequence& tracked,
                             const HandOverOptions& options) {
  const auto frames = static_cast<double>(sequence.size());
  const bool possible = sequence.has_color() && has_feature_matcher();
  if (!possible || frames > options.max_frames) return "";
  const std::size_t doubtful = tracked.log.doubtful();
  if (static_cast<double>(doubtful) > options.max_doubtful * frames) {
    return fmt::format("tracking leaves {} of {} frames in doubt", doubtful, sequence.size());
  }
  const double rotation = median_rotation(tracked.placed);
  if (rotation > options.max_rotation) {
    return fmt::format("the frames are {:.1f} degrees apart", degrees(rotation));
  }
  return "";
}

std::optional<PlacedSequence> stitch_sequence(const DepthSequence& sequence, std::size_t step,
                                              double min_placed, const StitchingOptions& stitching,
                                              const ReconstructionOptions& options,
                                              StageTimer& timer) {
  const ReadFrames read = timer.time("read again", [&] { return read_all(sequence); });
  const StitchingResult stitched =
      stitch_sweep(read.frames, sequence.camera(), stitching, options.tracking);
  for (const StageTime& time : stitched.times) timer.add("stitch: " + time.stage, time.seconds);
  if (stitched.placed == 0 || static_cast<double>(stitched.placed) < min_placed) return {};
  PlacedSequence result{fuse_placed(stitched, read, sequence.camera(), options),
                        placed_frames(stitched, read), FrameLog(step)};
  std::size_t next = 0;
  for (std::size_t k = 0; k < read.frames.size(); ++k) {
    for (; next < read.numbers[k]; ++next) result.log.add_unreadable(next);
    ++next;
    const StitchedFrame& frame = stitched.frames[k];
    if (frame.T_world_camera) {
      result.log.add_stitched(read.numbers[k]);
    } else {
      result.log.add_lost(read.numbers[k], frame.reason);
    }
  }
  for (; next < sequence.size(); ++next) result.log.add_unreadable(next);
  return result;
}

}  // namespace symscene::app
