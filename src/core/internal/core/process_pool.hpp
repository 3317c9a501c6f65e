#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace symscene {

/// The outcome of one item of work.
struct ItemOutcome {
  std::size_t item = 0;
  bool done = false;
  std::string text;  ///< what the work returned, or a sentence that describes the failure
};

/// Processes that work on numbered items in parallel, each item in its own process, so that a crash
/// loses one item only. They see a copy of the memory from when the pool was made. The pool must be
/// made before this process starts other threads; its processes end with this one.
class ProcessPool {
 public:
  /// The work on one item. The text that it returns may have at most 60,000 bytes; the message of
  /// an exception becomes the text of the outcome.
  using Work = std::function<std::string(std::size_t item)>;

  /// An item that takes longer than `time_limit` is given up, and its process of the pool is lost;
  /// without a limit a stopped process is waited for. Throws InputError if no process can be
  /// started.
  ProcessPool(std::size_t processes, const Work& work,
              std::optional<std::chrono::milliseconds> time_limit = std::nullopt);
  ~ProcessPool();
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;

  /// Works on the items, starting them in order. `on_outcome` is called in this process as each one
  /// ends. If every process of the pool is killed, the remaining items are reported as not done.
  void run(const std::vector<std::size_t>& items,
           const std::function<void(const ItemOutcome&)>& on_outcome);

 private:
  struct Worker {
    pid_t process = -1;
    int socket = -1;
    bool busy = false;
    std::size_t item = 0;
    std::chrono::steady_clock::time_point begin = {};  ///< of the item
  };

  void add_worker(const Work& work);
  void close_workers();
  static bool give(Worker& worker, std::size_t item);
  static ItemOutcome take(Worker& worker);
  static void retire(Worker& worker);
  int milliseconds_left(const std::vector<Worker*>& busy) const;
  bool is_overdue(const Worker& worker) const;
  ItemOutcome give_up(Worker& worker) const;

  std::optional<std::chrono::milliseconds> time_limit_;
  std::vector<Worker> workers_;
};

/// Delays signals that end this process (SIGINT, SIGTERM, SIGHUP) while it lives, so that files are
/// written completely.
class SignalDelay {
 public:
  SignalDelay();
  ~SignalDelay();
  SignalDelay(const SignalDelay&) = delete;
  SignalDelay& operator=(const SignalDelay&) = delete;
};

}  // namespace symscene
