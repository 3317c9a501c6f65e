#pragma once

#include "io/recording.hpp"

namespace symscene::fuzz {

/// Reads every message of every topic.
inline bool read_all_messages(const RecordingPointer& recording) {
  for (const RecordedTopic& topic : recording->topics()) {
    for (const RecordedMessage& message : recording->messages(topic.name)) {
      recording->bytes(message);
    }
  }
  return true;
}

}  // namespace symscene::fuzz
