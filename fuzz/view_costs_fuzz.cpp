#include <cstdlib>

#include "accepted.hpp"
#include "io/view_costs.hpp"

/// Any bytes are costs of views, each at least 0, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const auto costs =
      fuzz::accepted([&] { return parse_view_costs(fuzz::as_bytes(data, size), "fuzz"); });
  if (!costs) return 0;
  for (const double cost : *costs)
    if (!(cost >= 0.0)) std::abort();
  return 0;
}
