#include "accepted.hpp"
#include "all_messages.hpp"

/// Any bytes are an MCAP file whose messages can be read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  fuzz::accepted([&] {
    return fuzz::read_all_messages(open_mcap_recording(fuzz::as_bytes(data, size), "fuzz"));
  });
  return 0;
}
