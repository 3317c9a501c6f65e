#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "io/ply.hpp"

/// Any bytes are a mesh that keeps its triangles when written and read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto mesh = fuzz::accepted([&] { return parse_ply_mesh(bytes, "fuzz"); });
  if (!mesh) return 0;
  const TriangleMesh again = parse_ply_mesh(format_ply(*mesh), "again");
  if (again.triangles != mesh->triangles) std::abort();
  return 0;
}
