#include "dataset_tally.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "dataset_worker.hpp"
#include "frame_rate.hpp"

namespace symscene::app {

void DatasetTally::add(const ItemOutcome& outcome, Session& session) {
  ++finished_;
  const std::string name = fmt::format("{:04}", outcome.item);
  const auto warn = [&](const std::string& text) {
    session.warn(fmt::format("scene {}: {}", name, text));
  };
  if (!outcome.done) {
    failed_.push_back(name);
    warn(outcome.text);
    return;
  }
  const SceneReport report = parse_report(outcome.text);
  objects_ += report.objects;
  for (const std::string& warning : report.warnings) warn(warning);
  for (const StageTime& time : report.stages) add_to_sums(stages_, time);
}

std::string DatasetTally::progress() const {
  std::string scene =
      fmt::format("scene {} of {}", std::min(total_, total_ - wanted_ + finished_ + 1), total_);
  if (finished_ == 0) return scene;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const double rest = static_cast<double>(wanted_ - finished_) / static_cast<double>(finished_);
  return fmt::format("{}, {} left", scene, rough_duration(rest * elapsed.count()));
}

}  // namespace symscene::app
