// TUM RGB-D, and ICL-NUIM in its TUM-compatible form.
#include <cmath>

#include "image_files.hpp"
#include "image_lists.hpp"
#include "image_sequence.hpp"
#include "pose_formats.hpp"
#include "sequence_layouts.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/trajectory.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

/// Value that is 1 m in both formats. [1/m]
constexpr double depth_scale = 5000.0;

/// Poses are not interpolated over longer gaps. [s]
constexpr double largest_pose_gap = 0.1;

std::vector<ImageFrame> frames_of_lists(const fs::path& path) {
  if (!fs::exists(path / "depth.txt")) return read_associations(path / "associations.txt");
  std::vector<TimedImage> colors;
  if (fs::exists(path / "rgb.txt")) colors = read_image_list(path / "rgb.txt");
  std::vector<ImageFrame> frames;
  for (const TimedImage& depth : read_image_list(path / "depth.txt")) {
    frames.push_back({depth.time, depth.file,
                      nearest_image(colors, depth.time, association_tolerance), std::nullopt});
  }
  return frames;
}

/// Frames with numbers, which are used as times.
std::vector<ImageFrame> numbered_frames(const fs::path& path) {
  if (fs::exists(path / "associations.txt")) return read_associations(path / "associations.txt");
  std::vector<ImageFrame> frames;
  for (const fs::path& depth : files_ending(path / "depth", {".png"})) {
    const auto number = digits(depth.stem().string());
    if (!number) continue;
    const fs::path color = path / "rgb" / depth.filename();
    frames.push_back({static_cast<double>(*number), depth, fs::exists(color) ? color : fs::path(),
                      std::nullopt});
  }
  return frames;
}

/// The camera of ICL-NUIM, documented as (481.2, −480, 319.5, 239.5) because its y axis points up.
constexpr CameraIntrinsics icl_camera{640, 480, 481.2, 480.0, 319.5, 239.5};

/// Converts axes x right, y up, z forward to y down, by mirroring both camera and world.
Eigen::Isometry3d y_down(const Eigen::Isometry3d& y_up) {
  const Eigen::Vector3d flip(1.0, -1.0, 1.0);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = flip.asDiagonal() * y_up.linear() * flip.asDiagonal();
  pose.translation() = flip.cwiseProduct(y_up.translation());
  return pose;
}

}  // namespace

bool is_tum(const fs::path& path) {
  return fs::exists(path / "depth.txt") || fs::exists(path / "associations.txt");
}

SequencePointer open_tum(const fs::path& path, const SequenceOptions& options) {
  constexpr const char* layout = "TUM RGB-D";
  const Calibration calibration =
      resolve_calibration(path, layout, {std::nullopt, depth_scale}, options);
  ImageFrames content{path, layout, calibration, 0, frames_of_lists(path)};
  if (fs::exists(path / "groundtruth.txt")) {
    const Trajectory truth = read_trajectory(path / "groundtruth.txt");
    for (ImageFrame& frame : content.frames) {
      frame.T_world_camera = pose_at(truth, frame.time, largest_pose_gap);
    }
  }
  return make_image_sequence(std::move(content));
}

bool is_icl_nuim(const fs::path& path) { return !files_ending(path, {".gt.freiburg"}).empty(); }

SequencePointer open_icl_nuim(const fs::path& path, const SequenceOptions& options) {
  constexpr const char* layout = "ICL-NUIM";
  SequenceOptions given = options;
  if (given.intrinsics) given.intrinsics->fy = std::abs(given.intrinsics->fy);
  const Calibration calibration =
      resolve_calibration(path, layout, {icl_camera, depth_scale}, given);
  ImageFrames content{path, layout, calibration, 0, numbered_frames(path)};
  const Trajectory truth = read_trajectory(files_ending(path, {".gt.freiburg"}).front());
  for (ImageFrame& frame : content.frames) {
    const auto pose = pose_at(truth, frame.time, 0.0);
    if (pose) frame.T_world_camera = y_down(*pose);
    frame.time /= default_rate;
  }
  return make_image_sequence(std::move(content));
}

}  // namespace symscene
