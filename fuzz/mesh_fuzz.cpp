#include "accepted.hpp"
#include "symscene/io/mesh.hpp"

/// The first byte chooses OBJ, STL, GLB or glTF; any bytes after it are a mesh or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  if (size == 0) return 0;
  static constexpr const char* extensions[] = {"obj", "stl", "glb", "gltf"};
  fuzz::accepted([&] { return parse_mesh(bytes.substr(1), extensions[data[0] % 4], "fuzz"); });
  return 0;
}
