#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "symscene/io/robot.hpp"

/// Any bytes are a description of a robot with a home within its limits, or refused. Texts that
/// could name a file elsewhere are left out.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  if (bytes.find_first_of("/\\") != std::string_view::npos) return 0;
  const auto robot = fuzz::accepted([&] { return parse_robot(bytes, "fuzz", {}); });
  if (!robot) return 0;
  robot->model.validate();
  if (robot->arms.empty() || !robot->home.allFinite()) std::abort();
  return 0;
}
