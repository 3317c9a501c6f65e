// SymScene's own sequence folder.
#include <fmt/format.h>

#include "image_files.hpp"
#include "image_sequence.hpp"
#include "io/atomic_file.hpp"
#include "sequence_layouts.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/intrinsics.hpp"
#include "symscene/io/trajectory.hpp"
#include "text.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

constexpr const char* own_layout = "sequence";

/// The colour image of the same number; empty if there is none.
fs::path color_beside(const fs::path& dir, const std::string& number) {
  for (const char* ending : {".png", ".jpg"}) {
    if (fs::path file = dir / "color" / (number + ending); fs::exists(file)) return file;
  }
  return {};
}

std::vector<ImageFrame> find_frames(const fs::path& dir) {
  std::vector<ImageFrame> frames;
  for (const fs::path& file : files_ending(dir / "depth", {".png"})) {
    const std::string number = file.stem().string();
    if (!digits(number)) continue;
    const double time = static_cast<double>(frames.size()) / default_rate;
    frames.push_back({time, file, color_beside(dir, number), std::nullopt});
  }
  return frames;
}

void require_line_per_frame(std::size_t lines, std::size_t frames, const fs::path& file) {
  if (lines == frames) return;
  throw InputError(file.string(), fmt::format("{} lines, one per depth image", frames),
                   fmt::format("{}", lines));
}

void set_own_poses(std::vector<ImageFrame>& frames, const fs::path& file) {
  const Trajectory poses = read_trajectory(file);
  require_line_per_frame(poses.size(), frames.size(), file);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].time = poses[i].time;
    frames[i].T_world_camera = poses[i].T_world_camera;
  }
}

void set_times(std::vector<ImageFrame>& frames, const fs::path& file) {
  const std::vector<double> times = parse_times(read_file(file), file.string());
  require_line_per_frame(times.size(), frames.size(), file);
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].time = times[i];
}

}  // namespace

bool is_own_layout(const fs::path& path) {
  return fs::is_directory(path / "depth") && fs::exists(path / "intrinsics.txt");
}

bool is_own_layout_without_camera(const fs::path& path) { return fs::is_directory(path / "depth"); }

SequencePointer open_own_layout(const fs::path& path, const SequenceOptions& options) {
  ImageFrames content{path, own_layout, {std::nullopt, 1000.0}, 0, find_frames(path)};
  const fs::path intrinsics = path / "intrinsics.txt";
  if (fs::exists(intrinsics)) content.calibration.intrinsics = read_intrinsics(intrinsics);
  content.calibration = resolve_calibration(path, own_layout, content.calibration, options);
  if (fs::exists(path / "poses.txt")) {
    set_own_poses(content.frames, path / "poses.txt");
  } else if (fs::exists(path / "times.txt")) {
    set_times(content.frames, path / "times.txt");
  }
  return make_image_sequence(std::move(content));
}

}  // namespace symscene
