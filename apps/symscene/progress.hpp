#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace symscene::app {

/// Whether standard error is a terminal.
bool stderr_is_terminal();

/// A progress line on the terminal with the current stage, shown after one second and erased at the
/// end.
class Progress {
 public:
  /// Shows nothing unless `enabled`.
  explicit Progress(bool enabled);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void begin(const std::string& stage);

  /// Erases the progress line for good.
  void stop();

  /// Prints a line above the progress line.
  void print_line(const std::string& line);

 private:
  void draw_until(const std::stop_token& stop);
  void erase();

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::string stage_;
  bool drawn_ = false;
  std::jthread painter_;  ///< last, so that it stops before the members that it reads
};

}  // namespace symscene::app
