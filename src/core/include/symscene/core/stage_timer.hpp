#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace symscene {

struct StageTime {
  std::string stage;
  double seconds = 0.0;  ///< wall time
};

/// Measures the wall time of stages, in the order in which they run. One timer per run, owned by
/// the caller.
class StageTimer {
 public:
  /// Called with the name of each stage when it begins, to show progress.
  using OnBegin = std::function<void(const std::string&)>;

  StageTimer() = default;
  explicit StageTimer(OnBegin on_begin) : on_begin_(std::move(on_begin)) {}

  /// Runs `body`, adds its wall time under `stage` and returns its result.
  template <class Body>
  decltype(auto) time(const std::string& stage, Body&& body) {
    if (on_begin_) on_begin_(stage);
    const Stop stop{*this, stage, std::chrono::steady_clock::now()};
    return std::forward<Body>(body)();
  }

  /// Adds a time that was measured elsewhere.
  void add(std::string stage, double seconds) { stages_.push_back({std::move(stage), seconds}); }

  const std::vector<StageTime>& stages() const { return stages_; }
  double total() const {
    double sum = 0.0;
    for (const StageTime& entry : stages_) sum += entry.seconds;
    return sum;
  }

 private:
  struct Stop {
    StageTimer& timer;
    const std::string& stage;
    std::chrono::steady_clock::time_point start;
    ~Stop() {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      timer.stages_.push_back({stage, elapsed.count()});
    }
  };

  OnBegin on_begin_;
  std::vector<StageTime> stages_;
};

}  // namespace symscene
