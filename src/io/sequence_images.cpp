// Depth images alone: one file, or a folder of them.
#include "image_files.hpp"
#include "image_sequence.hpp"
#include "sequence_layouts.hpp"
#include "symscene/io/image.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

SequencePointer open_images(const fs::path& path, const std::string& layout,
                            const std::vector<fs::path>& files, const SequenceOptions& options) {
  ImageFrames content{path, layout, resolve_calibration(path, layout, {}, options), 0, {}};
  for (const fs::path& file : files) {
    const double time = static_cast<double>(content.frames.size()) / default_rate;
    content.frames.push_back({time, file, {}, std::nullopt});
  }
  return make_image_sequence(std::move(content));
}

}  // namespace

bool is_single_image(const fs::path& path) {
  return path.extension() == ".png" && fs::is_regular_file(path);
}

SequencePointer open_single_image(const fs::path& path, const SequenceOptions& options) {
  if (!is_depth_png(path)) read_depth_png(path);  // throws, and describes the image
  return open_images(path, "image", {path}, options);
}

bool is_image_folder(const fs::path& path) {
  for (const fs::path& file : files_ending(path, {".png"})) {
    if (is_depth_png(file)) return true;
  }
  return false;
}

SequencePointer open_image_folder(const fs::path& path, const SequenceOptions& options) {
  std::vector<fs::path> files = files_ending(path, {".png"});
  std::erase_if(files, [](const fs::path& file) { return !is_depth_png(file); });
  return open_images(path, "images", files, options);
}

}  // namespace symscene
