#pragma once

#include <string>
#include <vector>

#include "symscene/reconstruction/reconstruction.hpp"

namespace symscene::app {

/// The status of each frame of a sequence, as runs of frames with equal status.
class FrameLog {
 public:
  /// Frames are added by their numbers among every `step`-th of the sequence, and told by those in
  /// the sequence.
  explicit FrameLog(std::size_t step = 1) : step_(step) {}

  void add(std::size_t frame, const FrameReport& report);
  void add_unreadable(std::size_t frame);
  void add_lost(std::size_t frame, const std::string& reason);
  void add_stitched(std::size_t frame);

  /// A warning about the frames.
  void warn(const std::string& warning) { warnings_.push_back(warning); }
  const std::vector<std::string>& warnings() const { return warnings_; }

  std::size_t fused() const { return fused_; }
  /// Frames that show enough, but are lost or degenerate.
  std::size_t doubtful() const { return doubtful_; }

  /// Describes the first run.
  std::string first_run() const;

  /// A summary line, and one line per run of frames whose tracking did not converge.
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
  std::string describe(const Run& run) const;

  std::size_t step_;
  std::vector<Run> runs_;
  std::vector<std::string> warnings_;
  std::size_t frames_ = 0;
  std::size_t fused_ = 0;
  std::size_t doubtful_ = 0;
  std::size_t relocalized_ = 0;
};

}  // namespace symscene::app
