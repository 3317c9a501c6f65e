#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "core/process_pool.hpp"
#include "session.hpp"

namespace symscene::app {

/// Sums up the scenes of a dataset as they are finished.
class DatasetTally {
 public:
  /// Of `total` scenes in the dataset, `wanted` are to be made now.
  DatasetTally(std::size_t total, std::size_t wanted) : total_(total), wanted_(wanted) {}

  /// Counts a scene and prints its warnings.
  void add(const ItemOutcome& outcome, Session& session);

  /// "scene 12 of 89, 8 min left"
  std::string progress() const;

  std::size_t objects() const { return objects_; }
  /// The names of the scenes that could not be made.
  const std::vector<std::string>& failed() const { return failed_; }
  /// Wall time by stage, summed over scenes.
  const std::vector<StageTime>& stages() const { return stages_; }

 private:
  std::size_t total_;
  std::size_t wanted_;
  std::size_t finished_ = 0;
  std::size_t objects_ = 0;
  std::vector<std::string> failed_;
  std::vector<StageTime> stages_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace symscene::app
