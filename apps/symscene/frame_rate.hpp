#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace symscene::app {

/// How many frames were processed per second, and how long the rest takes.
class FrameRate {
 public:
  explicit FrameRate(std::size_t frames);

  /// "frame 8 of 120, 14.2 per second, 8 s left", before frame `done` is processed. Times are told
  /// once a second has passed.
  std::string progress(std::size_t done) const;

  /// "120 frames in 8.4 s: 14.2 per second".
  std::string summary() const;
  /// Of all frames. [1/s]
  double per_second() const;

 private:
  double seconds() const;

  std::size_t frames_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The text of progress() after `seconds`.
std::string frame_progress(std::size_t done, std::size_t frames, double seconds);

/// "8 s", "2 min", "1.5 h".
std::string rough_duration(double seconds);

}  // namespace symscene::app
