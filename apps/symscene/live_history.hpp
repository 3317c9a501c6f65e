#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "live_report.hpp"

namespace symscene::app {

/// The last updates of a live scene, for several readers that wait for the next one.
class LiveHistory {
 public:
  /// The updates that are kept: at most this many, and at most this many points of all.
  static constexpr std::size_t max_updates = 600;
  static constexpr std::size_t max_points = 8'000'000;

  void add(std::shared_ptr<const LiveReport> report);
  void finish();  ///< no update follows
  void close();   ///< and readers end

  /// An update that is kept; none otherwise.
  std::shared_ptr<const LiveReport> find(std::size_t number) const;

  struct News {
    std::shared_ptr<const LiveReport> newest;  ///< none before the first
    std::size_t oldest = 0;                    ///< number of the oldest that is kept
    bool is_finished = false;
    bool is_closed = false;
  };
  /// What is new to a reader that knows `known`; waits for it at most so long.
  News wait(std::size_t known, bool knows_end, std::chrono::milliseconds longest) const;

 private:
  std::size_t newest_number() const { return kept_.empty() ? 0 : kept_.back()->number; }

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::deque<std::shared_ptr<const LiveReport>> kept_;
  std::size_t points_ = 0;
  bool is_finished_ = false;
  bool is_closed_ = false;
};

}  // namespace symscene::app
