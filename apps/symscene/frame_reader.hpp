#pragma once

#include <cstddef>
#include <future>
#include <utility>

#include "symscene/io/sequence.hpp"

namespace symscene::app {

/// Reads the frames of a sequence, one ahead of the frame in use.
class FrameReader {
 public:
  explicit FrameReader(const DepthSequence& sequence) : sequence_(sequence) { start(); }

  /// The next frame. Throws InputError if it cannot be read; the following frame can still be read.
  DepthFrame next() {
    std::future<DepthFrame> current = std::move(ahead_);
    start();
    return current.get();
  }

 private:
  void start() {
    if (next_ == sequence_.size()) return;
    ahead_ = std::async(std::launch::async, [this, i = next_] { return sequence_.read(i); });
    ++next_;
  }

  const DepthSequence& sequence_;
  std::size_t next_ = 0;
  std::future<DepthFrame> ahead_;
};

}  // namespace symscene::app
