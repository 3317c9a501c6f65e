#pragma once

namespace symscene::app {

/// While it lives, the first SIGINT (Ctrl-C) or SIGTERM asks the command to end its work in order;
/// a second one ends the process.
class StopRequest {
 public:
  StopRequest();
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  bool is_made() const;
  /// Sleeps until it is made.
  void wait() const;
};

}  // namespace symscene::app
