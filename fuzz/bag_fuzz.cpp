#include <string>

#include "accepted.hpp"
#include "io/bag.hpp"

/// Any bytes are a consistent ROS 1 bag or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  fuzz::accepted([&] {
    require_sound_bag(fuzz::as_bytes(data, size), "fuzz");
    return true;
  });
  return 0;
}
