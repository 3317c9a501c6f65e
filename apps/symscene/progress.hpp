#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace symscene::app {

/// Whether standard error is a terminal.
bool stderr_is_terminal();

/// A line on the terminal that names the stage at work, for what takes over a second; gone when
/// done.
class Progress {
 public:
  /// Shows nothing unless `enabled`.
  explicit Progress(bool enabled);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void begin(const std::string& stage);

  /// Ends it and leaves an empty line.
  void stop();

  /// Writes a line of its own, without a tear in the progress line.
  void print_line(const std::string& line);

 private:
  void draw_until(const std::stop_token& stop);
  void erase();

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::string stage_;
  bool drawn_ = false;
  std::jthread painter_;  ///< last: it ends before what it reads does
};

}  // namespace symscene::app
