#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "symscene/io/octomap.hpp"

/// Any bytes are a map that keeps its number of leaves when written and read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto map = fuzz::accepted([&] { return parse_octomap(bytes, "fuzz"); });
  if (!map) return 0;
  const OccupancyMap again = parse_octomap(format_octomap(*map), "again");
  if (again.leaves.size() != map->leaves.size()) std::abort();
  return 0;
}
