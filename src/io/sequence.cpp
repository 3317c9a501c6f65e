#include "symscene/io/sequence.hpp"

#include <fmt/format.h>

#include "rectified_sequence.hpp"
#include "sequence_layouts.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

constexpr const char* a_sequence =
    "a sequence of depth images: a folder in the layout of SymScene, TUM RGB-D, ICL-NUIM, 7-Scenes "
    "or Redwood, a recording of ROS (.bag, .mcap, .db3 or a folder of rosbag2), or images of "
    "16-bit grey";

struct Layout {
  bool (*recognises)(const fs::path& path);
  SequencePointer (*open)(const fs::path& path, const SequenceOptions& options);
};

/// The first layout that recognises a path opens it.
constexpr Layout layouts[] = {
    {is_own_layout, open_own_layout},
    {is_icl_nuim, open_icl_nuim},
    {is_tum, open_tum},
    {is_seven_scenes, open_seven_scenes},
    {is_redwood, open_redwood},
    {is_own_layout_without_camera, open_own_layout},
    {is_bag, open_bag},
    {is_mcap, open_mcap},
    {is_rosbag2, open_rosbag2},
    {is_single_image, open_single_image},
    {is_image_folder, open_image_folder},
};

/// A principal point outside the image is nearly always that of another resolution.
void require_center_in_image(const CameraIntrinsics& camera, const fs::path& path) {
  const auto is_within = [](double center, Index size) {
    return center > -0.5 && center < static_cast<double>(size) - 0.5;
  };
  if (is_within(camera.cx, camera.width) && is_within(camera.cy, camera.height)) return;
  throw InputError(
      path.string() + ": intrinsics",
      fmt::format("a principal point in the image of {}×{} pixels", camera.width, camera.height),
      fmt::format("{},{}", camera.cx, camera.cy));
}

/// Null if no layout recognises the path.
const Layout* layout_of(const fs::path& path) {
  for (const Layout& layout : layouts) {
    if (layout.recognises(path)) return &layout;
  }
  return nullptr;
}

}  // namespace

bool is_sequence(const fs::path& path) { return layout_of(path) != nullptr; }

SequencePointer open_sequence(const fs::path& path, const SequenceOptions& options) {
  if (!fs::exists(path)) throw InputError(path.string(), a_sequence, "nothing of that name");
  const Layout* layout = layout_of(path);
  if (layout == nullptr) {
    throw InputError(path.string(), a_sequence,
                     fs::is_directory(path) ? "another folder" : "another file");
  }
  SequenceOptions used = options;
  if (options.camera) used.intrinsics = options.camera->intrinsics;
  SequencePointer sequence = layout->open(path, used);
  require_center_in_image(sequence->camera(), path);
  return options.camera ? rectified_sequence(std::move(sequence), *options.camera)
                        : std::move(sequence);
}

}  // namespace symscene
