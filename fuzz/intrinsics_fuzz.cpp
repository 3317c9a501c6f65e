#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "io/camera_formats.hpp"
#include "symscene/io/intrinsics.hpp"

/// Any bytes are a camera, as text or JSON, that keeps its bits when written and read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  for (const auto parse : {parse_intrinsics, parse_intrinsics_json}) {
    const auto camera = fuzz::accepted([&] { return parse(bytes, "fuzz"); });
    if (!camera) continue;
    const CameraIntrinsics again = parse_intrinsics(format_intrinsics(*camera), "again");
    if (again.width != camera->width || again.fx != camera->fx || again.cy != camera->cy) {
      std::abort();
    }
  }
  return 0;
}
