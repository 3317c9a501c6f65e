#include "frame_rate.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "counted.hpp"

namespace symscene::app {

FrameRate::FrameRate(std::size_t frames) : frames_(frames) {}

double FrameRate::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::string FrameRate::progress(std::size_t done) const {
  return frame_progress(done, frames_, seconds());
}

double FrameRate::per_second() const {
  return static_cast<double>(frames_) / std::max(seconds(), 1e-9);
}

std::string FrameRate::summary() const {
  return fmt::format("{} in {:.1f} s: {:.1f} per second", counted(frames_, "frame"), seconds(),
                     per_second());
}

std::string frame_progress(std::size_t done, std::size_t frames, double seconds) {
  std::string text = fmt::format("frame {} of {}", done + 1, frames);
  if (done == 0 || seconds < 1.0) return text;
  const double each = seconds / static_cast<double>(done);
  const double left = each * static_cast<double>(frames - done);
  return text + fmt::format(", {:.1f} per second, {} left", 1.0 / each, rough_duration(left));
}

std::string rough_duration(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 5400.0) return fmt::format("{:.0f} min", std::ceil(seconds / 60.0));
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace symscene::app
