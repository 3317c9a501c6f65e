#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "symscene/io/table_plane.hpp"

/// Any bytes are a plane that keeps its bits when written and read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto plane = fuzz::accepted([&] { return parse_table_plane(bytes, "fuzz"); });
  if (!plane) return 0;
  const Plane again = parse_table_plane(format_table_plane(*plane), "again");
  if (again.normal != plane->normal || again.offset != plane->offset) std::abort();
  return 0;
}
