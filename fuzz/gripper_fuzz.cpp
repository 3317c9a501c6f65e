#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "symscene/io/gripper.hpp"

/// Any bytes are a gripper, in JSON or YAML, that keeps its text when written and read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  for (const char* name : {"fuzz.json", "fuzz.yaml"}) {
    const auto gripper = fuzz::accepted([&] { return parse_gripper(bytes, name); });
    if (!gripper) continue;
    gripper->validate();
    // YAML may hold names that JSON cannot: text that is not UTF-8.
    const auto text = fuzz::accepted([&] { return format_gripper(*gripper); });
    if (text && format_gripper(parse_gripper(*text, "again.json")) != *text) std::abort();
  }
  return 0;
}
