#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "symscene/core/frame_rectifier.hpp"
#include "symscene/io/camera_file.hpp"

/// Any bytes are a calibrated camera that keeps its text when written and read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  auto camera = fuzz::accepted([&] { return parse_camera_model(bytes, "fuzz.yaml"); });
  if (!camera) return 0;
  camera->color.reset();  // whose pose is read back up to rounding
  const std::string text = format_camera_model(*camera);
  if (format_camera_model(parse_camera_model(text, "again.yaml")) != text) std::abort();
  if (camera->intrinsics.pixels() <= 4096) FrameRectifier{*camera};
  return 0;
}
