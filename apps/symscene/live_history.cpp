#include "live_history.hpp"

#include <utility>

namespace symscene::app {
namespace {

std::size_t points_of(const LiveReport& report) {
  return static_cast<std::size_t>(report.update.result.cloud.size());
}

}  // namespace

void LiveHistory::add(std::shared_ptr<const LiveReport> report) {
  {
    const std::lock_guard lock(mutex_);
    points_ += points_of(*report);
    kept_.push_back(std::move(report));
    while (kept_.size() > 1 && (kept_.size() > max_updates || points_ > max_points)) {
      points_ -= points_of(*kept_.front());
      kept_.pop_front();
    }
  }
  changed_.notify_all();
}

void LiveHistory::finish() {
  {
    const std::lock_guard lock(mutex_);
    is_finished_ = true;
  }
  changed_.notify_all();
}

void LiveHistory::close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
  }
  changed_.notify_all();
}

std::shared_ptr<const LiveReport> LiveHistory::find(std::size_t number) const {
  const std::lock_guard lock(mutex_);
  if (kept_.empty() || number < kept_.front()->number || number > newest_number()) return nullptr;
  return kept_[number - kept_.front()->number];
}

LiveHistory::News LiveHistory::wait(std::size_t known, bool knows_end,
                                    std::chrono::milliseconds longest) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, longest, [&] {
    return is_closed_ || newest_number() > known || (is_finished_ && !knows_end);
  });
  News news{nullptr, 0, is_finished_, is_closed_};
  if (newest_number() > known) news.newest = kept_.back();
  if (!kept_.empty()) news.oldest = kept_.front()->number;
  return news;
}

}  // namespace symscene::app
