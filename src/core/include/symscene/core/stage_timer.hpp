#pragma once

#include <algorithm>
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

/// Adds a time to that of the same stage; a new stage comes last.
inline void add_to_sums(std::vector<StageTime>& sums, const StageTime& time) {
  const auto sum = std::find_if(sums.begin(), sums.end(),
                                [&](const StageTime& known) { return known.stage == time.stage; });
  if (sum == sums.end())
    sums.push_back(time);
  else
    sum->seconds += time.seconds;
}

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
