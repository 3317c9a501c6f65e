#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace symscene {

/// What came of an item of work.
struct ItemOutcome {
  std::size_t item = 0;
  bool done = false;
  std::string text;  ///< what the work returned, or a sentence about what went wrong
};

/// Processes that work on numbered items side by side, each item in a process of its own: one that
/// crashes or is killed takes no other with it. They share nothing but what was in memory when the
/// pool was made, which has to be before this process uses other threads, and end with it.
class ProcessPool {
 public:
  /// What is done with an item, in a process of its own. What it returns has to be short, at most
  /// 60,000 bytes; what it throws becomes the outcome's sentence.
  using Work = std::function<std::string(std::size_t item)>;

  /// Throws InputError if the system gives no process.
  ProcessPool(std::size_t processes, const Work& work);
  ~ProcessPool();
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;

  /// Works on the items, beginning them in their order. `on_outcome` is called here for each as it
  /// comes in. Items that are left when every process of the pool was killed are not done.
  void run(const std::vector<std::size_t>& items,
           const std::function<void(const ItemOutcome&)>& on_outcome);

 private:
  struct Worker {
    pid_t process = -1;
    int socket = -1;
    bool busy = false;
    std::size_t item = 0;
  };

  void add_worker(const Work& work);
  void close_workers();
  static bool give(Worker& worker, std::size_t item);
  static ItemOutcome take(Worker& worker);
  static void retire(Worker& worker);

  std::vector<Worker> workers_;
};

/// Holds back requests to end this process (SIGINT, SIGTERM, SIGHUP) while it lives, so that what
/// is written meanwhile is whole.
class SignalDelay {
 public:
  SignalDelay();
  ~SignalDelay();
  SignalDelay(const SignalDelay&) = delete;
  SignalDelay& operator=(const SignalDelay&) = delete;
};

}  // namespace symscene
