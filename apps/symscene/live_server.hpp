#pragma once

#include <memory>
#include <string>

#include "live_report.hpp"

namespace symscene::app {

/// Where the page of a live scene is served.
struct LiveAddress {
  std::string host = "127.0.0.1";
  int port = 0;       ///< 0 for a free one
  std::string token;  ///< that each request must bring; empty for none

  /// Whether only programs of this machine reach it.
  bool is_loopback() const;
};

/// 128 random bits of the operating system, as hexadecimal digits.
std::string random_token();

/// Serves the page of a live scene and its updates: / is the page, /events a stream of server-sent
/// events with the report of each update, /updates/N?points=M the points of a kept update. With a
/// token, requests bring it as ?token=. Without one, requests for another host than the server's
/// are refused, so that no page of the web reads the scene by a name that it points here.
class LiveServer {
 public:
  /// Whether the build has an HTTP server (libcpp-httplib-dev).
  static bool is_built();

  /// Starts to serve. Throws InputError if the address cannot be bound, or without is_built().
  LiveServer(const LiveAddress& address, std::string page);
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  /// Of the page, with the token.
  std::string url() const;

  /// Makes an update the newest. Those before it are kept while they are few and small.
  void publish(std::shared_ptr<const LiveReport> report);

  /// Tells the pages that no update follows. The kept ones stay.
  void finish();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene::app
