#pragma once

#include <string>
#include <vector>

#include "symscene/reconstruction/reconstruction.hpp"

namespace symscene::app {

/// What became of a sequence's frames, in runs of frames that fared alike.
class FrameLog {
 public:
  void add(std::size_t frame, const FrameReport& report);
  void add_unreadable(std::size_t frame);
  void add_lost(std::size_t frame, const std::string& reason);

  std::size_t fused() const { return fused_; }

  /// What became of the first frames.
  std::string first_run() const;

  /// A line for all frames, and one for every run of frames that were not simply tracked.
  std::vector<std::string> lines() const;

  /// Counts and runs as a JSON object.
  std::string json() const;

 private:
  struct Run {
    std::string status;
    std::string detail;
    std::size_t first = 0;
    std::size_t last = 0;
  };

  void add(std::size_t frame, const std::string& status, const std::string& detail);
  std::size_t count(const std::string& status) const;
  static std::string describe(const Run& run);

  std::vector<Run> runs_;
  std::size_t frames_ = 0;
  std::size_t fused_ = 0;
  std::size_t relocalized_ = 0;
};

}  // namespace symscene::app
