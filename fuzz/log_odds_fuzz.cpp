#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "io/octomap_log_odds.hpp"

/// Any bytes are a map that keeps its number of leaves when written and read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto map = fuzz::accepted([&] { return parse_log_odds(bytes, "fuzz"); });
  if (!map) return 0;
  const LogOddsMap again = parse_log_odds(format_log_odds(*map), "again");
  const bool whole = map->leaves.size() == 1 && map->leaves[0].level == octree_depth;
  if (again.leaves.size() != (whole ? 8 : map->leaves.size())) std::abort();
  labels(*map);
  return 0;
}
