// 7-Scenes: a folder of frame-NNNNNN.depth.png, .color.png and .pose.txt.
#include <fmt/format.h>

#include "image_files.hpp"
#include "image_sequence.hpp"
#include "io/atomic_file.hpp"
#include "pose_formats.hpp"
#include "sequence_layouts.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

constexpr const char* seven_scenes_layout = "7-Scenes";
constexpr const char* depth_ending = ".depth.png";

/// The camera as the dataset documents it; it was not calibrated.
constexpr CameraIntrinsics documented_camera{640, 480, 585.0, 585.0, 320.0, 240.0};
/// The value of pixels without measurement.
constexpr std::uint16_t not_measured = 65535;

std::vector<fs::path> depth_files(const fs::path& path) {
  std::vector<fs::path> files = files_ending(path, {depth_ending});
  std::erase_if(
      files, [](const fs::path& file) { return !file.filename().string().starts_with("frame-"); });
  return files;
}

ImageFrame frame_of(const fs::path& depth, std::size_t position) {
  const std::string file = depth.string();
  const std::string stem = file.substr(0, file.size() - std::string_view(depth_ending).size());
  const std::string number = fs::path(stem).filename().string().substr(6);
  const auto place = static_cast<double>(digits(number).value_or(position));
  ImageFrame frame{place / default_rate, depth, stem + ".color.png", std::nullopt};
  if (!fs::exists(frame.color)) frame.color.clear();
  const std::string pose = stem + ".pose.txt";
  if (fs::exists(pose)) frame.T_world_camera = parse_pose_matrix(read_file(pose), pose);
  return frame;
}

void warn(ImageFrames& content, const char* what) {
  content.warnings.push_back(fmt::format("{}: 7-Scenes {}", content.path.string(), what));
}

}  // namespace

bool is_seven_scenes(const fs::path& path) { return !depth_files(path).empty(); }

SequencePointer open_seven_scenes(const fs::path& path, const SequenceOptions& options) {
  ImageFrames content{
      path,
      seven_scenes_layout,
      resolve_calibration(path, seven_scenes_layout, {documented_camera, 1000.0}, options),
      not_measured,
      {}};
  bool color = false;
  for (const fs::path& depth : depth_files(path)) {
    content.frames.push_back(frame_of(depth, content.frames.size()));
    color = color || !content.frames.back().color.empty();
  }
  if (!options.intrinsics) {
    warn(content,
         "documents its camera only as about 585,585,320,240, which is used here "
         "(to give a better one: --intrinsics fx,fy,cx,cy)");
  }
  if (color) warn(content, "did not register colour to depth: it is some pixels off");
  return make_image_sequence(std::move(content));
}

}  // namespace symscene
