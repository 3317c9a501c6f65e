#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "io/ply.hpp"

/// Any bytes are a point cloud that keeps its size when written and read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto cloud = fuzz::accepted([&] { return parse_ply_cloud(bytes, "fuzz"); });
  if (cloud && parse_ply_cloud(format_ply(*cloud), "again").size() != cloud->size()) std::abort();
  return 0;
}
