#include "live_loop.hpp"

#include <utility>

#include "core/spacing.hpp"
#include "symscene/core/error.hpp"

namespace symscene::app {

LiveLoop::LiveLoop(LiveScene& scene, const KnownTable& table, OnReport on_report)
    : scene_(scene), table_(table), on_report_(std::move(on_report)), thread_([this] { work(); }) {}

LiveLoop::~LiveLoop() {
  {
    const std::lock_guard lock(mutex_);
    is_abandoned_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

FrameReport LiveLoop::add(const DepthFrame& frame,
                          const std::optional<Eigen::Isometry3d>& T_world_camera, PoseUse use,
                          Clock::time_point arrived) {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [&] { return !is_snapshot_wanted_ || failure_; });
  if (failure_) std::rethrow_exception(failure_);
  const FrameReport report = scene_.add(frame, T_world_camera, use);
  if (!report.fused) ++lost_;
  frame_time_ = frame.time;
  arrived_ = arrived;
  lock.unlock();
  wake_.notify_all();
  return report;
}

void LiveLoop::finish() {
  {
    const std::lock_guard lock(mutex_);
    is_finishing_ = true;
  }
  wake_.notify_all();
  thread_.join();
  if (failure_) std::rethrow_exception(failure_);
}

void LiveLoop::work() {
  try {
    while (wait_for_frames()) on_report_(std::make_shared<const LiveReport>(make_report()));
  } catch (...) {
    const std::lock_guard lock(mutex_);
    is_snapshot_wanted_ = false;
    failure_ = std::current_exception();
    wake_.notify_all();
  }
}

/// Whether there are frames that no update holds yet; waits for them.
bool LiveLoop::wait_for_frames() {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [&] { return is_abandoned_ || is_finishing_ || scene_.frames() > segmented_; });
  is_snapshot_wanted_ = !is_abandoned_ && scene_.frames() > segmented_;
  return is_snapshot_wanted_;
}

/// The scene of the frames so far. Sets what the report tells of them, and when the last arrived.
LiveSnapshot LiveLoop::take_snapshot(LiveReport& report, Clock::time_point& arrived) {
  const std::lock_guard lock(mutex_);
  segmented_ = report.update.frames = scene_.frames();
  report.lost = lost_;
  report.frame_time = frame_time_;
  arrived = arrived_;
  is_snapshot_wanted_ = false;
  wake_.notify_all();  // a waiting add() goes on when the lock is released
  return scene_.snapshot(table_);
}

LiveReport LiveLoop::make_report() {
  LiveReport report;
  report.number = ++updates_;
  Clock::time_point arrived;
  try {
    report.update = scene_.update(take_snapshot(report, arrived));
  } catch (const InputError& error) {
    report.problem = error.what();  // the frames so far show no surface; those after them may
  }
  report.spacing = median_spacing(report.update.result.cloud.positions).value_or(0.0F);
  report.latency = std::chrono::duration<double>(Clock::now() - arrived).count();
  return report;
}

}  // namespace symscene::app
