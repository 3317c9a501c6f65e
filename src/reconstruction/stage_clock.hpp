#pragma once

#include <chrono>
#include <vector>

#include "symscene/core/stage_timer.hpp"

namespace symscene {

/// Wall time of the stages of a reconstruction, summed over its frames.
class StageClock {
 public:
  enum Stage : std::size_t { prepare, track, fuse, map_space, predict_view };

  /// Runs `body`, adds its wall time to `stage` and returns its result.
  template <class Body>
  auto time(Stage stage, const Body& body) {
    struct Stop {
      double& total;
      std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
      ~Stop() {
        total += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      }
    } const stop{times_[stage].seconds};
    return body();
  }

  const std::vector<StageTime>& times() const { return times_; }

 private:
  std::vector<StageTime> times_{
      {"prepare", 0}, {"track", 0}, {"fuse", 0}, {"map space", 0}, {"predict view", 0}};
};

}  // namespace symscene
