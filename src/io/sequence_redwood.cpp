// Redwood: depth/ beside image/, rgb/ or color/, a camera in JSON, a trajectory in a .log file.
#include <algorithm>

#include <fmt/format.h>

#include "camera_formats.hpp"
#include "image_files.hpp"
#include "image_lists.hpp"
#include "image_sequence.hpp"
#include "io/atomic_file.hpp"
#include "pose_formats.hpp"
#include "sequence_layouts.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

constexpr const char* redwood_layout = "Redwood";

/// Larger files are not read as camera files. [byte]
constexpr std::uintmax_t largest_camera_file = 1 << 20;

/// An image whose name is NUMBER or NUMBER-MICROSECONDS.
struct NumberedImage {
  std::uint64_t number = 0;
  std::optional<double> time;  ///< [s]
  fs::path file;
};

std::optional<NumberedImage> numbered_image(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t dash = stem.find('-');
  const auto number = digits(stem.substr(0, dash));
  if (!number) return std::nullopt;
  NumberedImage image{*number, std::nullopt, file};
  if (dash == std::string::npos) return image;
  const auto microseconds = digits(stem.substr(dash + 1));
  if (!microseconds) return std::nullopt;
  image.time = 1e-6 * static_cast<double>(*microseconds);
  return image;
}

std::vector<NumberedImage> numbered_images(const fs::path& dir) {
  std::vector<NumberedImage> images;
  for (const fs::path& file : files_ending(dir, {".png", ".jpg"})) {
    if (auto image = numbered_image(file)) images.push_back(std::move(*image));
  }
  return images;
}

fs::path color_folder(const fs::path& path) {
  for (const char* name : {"image", "rgb", "color"}) {
    if (fs::is_directory(path / name)) return path / name;
  }
  return {};
}

/// The colour images, found by number or by time.
class ColorImages {
 public:
  explicit ColorImages(const std::vector<NumberedImage>& images) : by_number_(images) {
    for (const NumberedImage& image : images) {
      if (image.time) by_time_.push_back({*image.time, image.file});
    }
  }

  fs::path beside(const NumberedImage& depth) const {
    if (depth.time) return nearest_image(by_time_, *depth.time, association_tolerance);
    const auto found = std::lower_bound(
        by_number_.begin(), by_number_.end(), depth.number,
        [](const NumberedImage& image, std::uint64_t number) { return image.number < number; });
    return found != by_number_.end() && found->number == depth.number ? found->file : fs::path();
  }

 private:
  std::vector<NumberedImage> by_number_;
  std::vector<TimedImage> by_time_;
};

/// The camera of the first JSON file that has one, whatever its name.
std::optional<CameraIntrinsics> find_camera(const fs::path& path) {
  for (const fs::path& file : files_ending(path, {".json"})) {
    if (fs::file_size(file) > largest_camera_file) continue;
    const std::string text = read_file(file);
    if (text.find("\"intrinsic_matrix\"") == std::string::npos) continue;
    return parse_intrinsics_json(text, file.string());
  }
  return std::nullopt;
}

/// trajectory.log, or the only .log file; empty, with a warning, if there are several.
fs::path find_log(const fs::path& path, std::vector<std::string>& warnings) {
  if (fs::exists(path / "trajectory.log")) return path / "trajectory.log";
  const std::vector<fs::path> logs = files_ending(path, {".log"});
  if (logs.size() > 1) {
    warnings.push_back(
        fmt::format("{}: {} .log files and none of them trajectory.log: read "
                    "without poses",
                    path.string(), logs.size()));
  }
  return logs.size() == 1 ? logs.front() : fs::path();
}

/// There is one pose per frame, or each pose has the number of its frame.
void set_redwood_poses(std::vector<ImageFrame>& frames, const fs::path& file) {
  const Trajectory poses = parse_trajectory_log(read_file(file), file.string());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double at = poses.size() == frames.size() ? static_cast<double>(i) : poses[i].time;
    if (!(at >= 0.0 && at < static_cast<double>(frames.size()))) {
      throw InputError(fmt::format("{}: pose {}", file.string(), i),
                       fmt::format("the number of one of {} frames", frames.size()),
                       fmt::format("{}", at));
    }
    frames[static_cast<std::size_t>(at)].T_world_camera = poses[i].T_world_camera;
  }
}

}  // namespace

bool is_redwood(const fs::path& path) {
  if (!fs::is_directory(path / "depth")) return false;
  return fs::is_directory(path / "image") || fs::is_directory(path / "rgb") ||
         !files_ending(path, {".json", ".log"}).empty();
}

SequencePointer open_redwood(const fs::path& path, const SequenceOptions& options) {
  std::optional<CameraIntrinsics> camera;
  if (!options.intrinsics) camera = find_camera(path);
  ImageFrames content{path,
                      redwood_layout,
                      resolve_calibration(path, redwood_layout, {camera, 1000.0}, options),
                      0,
                      {}};
  const fs::path colors_in = color_folder(path);
  const ColorImages colors(colors_in.empty() ? std::vector<NumberedImage>()
                                             : numbered_images(colors_in));
  for (const NumberedImage& depth : numbered_images(path / "depth")) {
    const double by_rate = static_cast<double>(content.frames.size()) / default_rate;
    content.frames.push_back(
        {depth.time.value_or(by_rate), depth.file, colors.beside(depth), std::nullopt});
  }
  const fs::path poses = find_log(path, content.warnings);
  if (!poses.empty()) set_redwood_poses(content.frames, poses);
  return make_image_sequence(std::move(content));
}

}  // namespace symscene
