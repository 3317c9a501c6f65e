#include <string>

#include "accepted.hpp"
#include "io/recording.hpp"

/// Any bytes are an MCAP file whose messages can be read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  fuzz::accepted([&] {
    const RecordingPointer recording = open_mcap_recording(fuzz::as_bytes(data, size), "fuzz");
    for (const RecordedTopic& topic : recording->topics()) {
      for (const RecordedMessage& message : recording->messages(topic.name)) {
        recording->bytes(message);
      }
    }
    return true;
  });
  return 0;
}
