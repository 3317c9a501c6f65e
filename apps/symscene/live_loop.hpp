#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "live_report.hpp"

namespace symscene::app {

/// Segments a live scene again and again in a thread of its own, while frames are added. An update
/// holds all frames that were added before it began.
class LiveLoop {
 public:
  using Clock = std::chrono::steady_clock;
  /// Called in the thread of the loop.
  using OnReport = std::function<void(std::shared_ptr<const LiveReport>)>;

  LiveLoop(LiveScene& scene, const KnownTable& table, OnReport on_report);
  ~LiveLoop();
  LiveLoop(const LiveLoop&) = delete;
  LiveLoop& operator=(const LiveLoop&) = delete;

  /// Adds a frame that arrived at a time. Throws as LiveScene::add(), and what ended the loop.
  FrameReport add(const DepthFrame& frame, const std::optional<Eigen::Isometry3d>& T_world_camera,
                  PoseUse use, Clock::time_point arrived);

  /// Waits until all frames are in an update. Throws what ended the loop. No frame is added after.
  void finish();

 private:
  void work();
  bool wait_for_frames();
  LiveReport make_report();
  LiveSnapshot take_snapshot(LiveReport& report, Clock::time_point& arrived);

  LiveScene& scene_;
  KnownTable table_;
  OnReport on_report_;

  std::mutex mutex_;  ///< of the members up to `failure_`, and of what add() changes in the scene
  std::condition_variable wake_;
  bool is_snapshot_wanted_ = false;  ///< no frame is added before it is taken
  bool is_finishing_ = false;
  bool is_abandoned_ = false;
  std::size_t segmented_ = 0;  ///< frames in the last snapshot
  std::size_t lost_ = 0;
  double frame_time_ = 0.0;
  Clock::time_point arrived_{};
  std::exception_ptr failure_;

  std::size_t updates_ = 0;  ///< of the thread
  std::thread thread_;
};

}  // namespace symscene::app
