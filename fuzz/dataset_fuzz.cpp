#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "accepted.hpp"
#include "symscene/dataset/dataset_folder.hpp"

namespace {

namespace fs = std::filesystem;

/// A folder with one scene whose dataset.json, scene.json and label image are the input.
const fs::path& folder() {
  static const fs::path path = [] {
    fs::path made = fs::temp_directory_path() / ("symscene-fuzz-" + std::to_string(getpid()));
    fs::create_directories(made / "made/scenes/0000");
    fs::create_directories(made / "scenes/one");
    for (const char* scene : {"made/scenes/0000", "scenes/one"})
      for (const char* file : {"cloud.ply", "truth.json"}) std::ofstream(made / scene / file);
    std::atexit([] { fs::remove_all(folder()); });
    return made;
  }();
  return path;
}

void write(const fs::path& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

/// Any bytes in the place of dataset.json, scene.json or a label image are a dataset, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  write(folder() / "made/dataset.json", bytes);
  fuzz::accepted([&] { return read_dataset(folder() / "made"); });
  write(folder() / "scenes/one/scene.json", bytes);
  fuzz::accepted([&] { return read_dataset(folder() / "scenes"); });
  const fs::path image = folder() / "scenes/one/scene.json";
  const CameraIntrinsics camera{4, 2, 5.0, 5.0, 1.5, 0.5};
  const auto frame = fuzz::accepted([&] {
    return read_labeled_frame({"fuzz", "", {}, image, image, camera});
  });
  if (frame && frame->labels.size() != 8) std::abort();
  return 0;
}
