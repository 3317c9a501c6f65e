#include <array>

#include <fmt/format.h>

#include "camera_formats.hpp"
#include "depth_millimetres.hpp"
#include "image_files.hpp"
#include "io/atomic_file.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/image.hpp"
#include "symscene/io/intrinsics.hpp"
#include "symscene/io/sequence.hpp"
#include "symscene/io/trajectory.hpp"
#include "text.hpp"

namespace symscene {
namespace {

constexpr const char* sequence_to_write = "sequence to write";

/// Whether `name` is FOLDER/NUMBER with one of the endings.
bool is_frame_file(const std::filesystem::path& name) {
  const std::string folder = name.parent_path().string();
  const std::string ending = name.extension().string();
  const bool image = folder == "depth"
                         ? ending == ".png"
                         : folder == "color" && (ending == ".png" || ending == ".jpg");
  return image && digits(name.stem().string());
}

/// Whether `name` is the mesh of an object of the ground truth: meshes/NAME.ply.
bool is_true_mesh(const std::filesystem::path& name) {
  return name.parent_path() == "meshes" && name.extension() == ".ply";
}

/// Optional files of a sequence: truth.json, table_plane.txt, meshes/mug.ply.
bool is_file_beside(const std::string& name) {
  if (is_true_mesh(name)) return true;
  return name.find('/') == std::string::npos && name.size() > 5 &&
         (name.ends_with(".json") || name == "table_plane.txt");
}

bool belongs_to_sequence(const std::string& relative) {
  static constexpr std::array<std::string_view, 6> own = {
      "depth/", "color/", "meshes/", "intrinsics.txt", "poses.txt", "times.txt"};
  return std::find(own.begin(), own.end(), relative) != own.end() || is_file_beside(relative) ||
         is_frame_file(relative);
}

}  // namespace

struct SequenceWriter::Implementation {
  Implementation(const std::filesystem::path& dir, const CameraIntrinsics& of)
      : camera(of), folder(dir, {"a sequence folder", "intrinsics.txt", belongs_to_sequence}) {}

  CameraIntrinsics camera;
  AtomicDirectory folder;
  Trajectory frames;  ///< identity if there is no pose
  bool posed = false;
  bool finished = false;

  ImageSize size() const { return {camera.width, camera.height}; }

  void require(const DepthFrame& frame, bool pose) const {
    if (finished) throw InputError(sequence_to_write, "no frame after the last", "one");
    if (!frames.empty() && pose != posed) {
      throw InputError(sequence_to_write, "a pose for all frames or for none",
                       "some with and some without");
    }
    if (!std::isfinite(frame.time) || (!frames.empty() && frame.time < frames.back().time)) {
      throw InputError(sequence_to_write, "frames by rising time",
                       fmt::format("time {}", frame.time));
    }
    const auto colors = static_cast<std::size_t>(frame.colors.rows());
    if (frame.depth.size() != camera.pixels() || (colors != 0 && colors != camera.pixels())) {
      throw InputError(sequence_to_write, fmt::format("frames of {} pixels", camera.pixels()),
                       fmt::format("{} of depth, {} of colour", frame.depth.size(), colors));
    }
  }

  std::string format_times() const {
    if (posed) return format_trajectory(frames);
    std::string text;
    for (const StampedPose& frame : frames) text += fmt::format("{}\n", frame.time);
    return text;
  }
};

SequenceWriter::SequenceWriter(const std::filesystem::path& dir, const CameraIntrinsics& camera) {
  require_camera(camera, sequence_to_write);
  if (camera.pixels() == 0) throw InputError(sequence_to_write, "a camera with pixels", "none");
  implementation_ = std::make_unique<Implementation>(dir, camera);
}

SequenceWriter::~SequenceWriter() = default;

void SequenceWriter::add(const DepthFrame& frame, const Eigen::Isometry3d* T_world_camera) {
  Implementation& to = *implementation_;
  to.require(frame, T_world_camera != nullptr);
  const std::string name = fmt::format("{:06}.png", to.frames.size());
  to.folder.write("depth/" + name, format_png(DepthImage{to.size(), to_millimetres(frame.depth)}));
  if (frame.colors.rows() != 0) {
    to.folder.write("color/" + name, format_png(ColorImage{to.size(), frame.colors}));
  }
  to.posed = T_world_camera != nullptr;
  to.frames.push_back(
      {frame.time, to.posed ? *T_world_camera : Eigen::Isometry3d(Eigen::Isometry3d::Identity())});
}

void SequenceWriter::add_file(const std::string& name, const std::string& content) {
  if (!is_file_beside(name)) {
    throw InputError(sequence_to_write,
                     "a file named NAME.json, table_plane.txt or meshes/NAME.ply beside the images",
                     in_quotes(name));
  }
  implementation_->folder.write(name, content);
}

void SequenceWriter::finish() {
  Implementation& to = *implementation_;
  if (to.finished) return;
  if (to.frames.empty()) throw InputError(sequence_to_write, "at least one frame", "none");
  to.folder.write("intrinsics.txt", format_intrinsics(to.camera));
  to.folder.write(to.posed ? "poses.txt" : "times.txt", to.format_times());
  to.folder.commit();
  to.finished = true;
}

}  // namespace symscene
