#include "stop_request.hpp"

#include <chrono>
#include <csignal>
#include <thread>

#include "symscene/io/staging.hpp"

namespace symscene::app {
namespace {

volatile std::sig_atomic_t is_requested = 0;

void request(int) {
  is_requested = 1;
  remove_staging_on_signals();  // the next signal ends the process
}

}  // namespace

StopRequest::StopRequest() {
  is_requested = 0;
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, request);
}

StopRequest::~StopRequest() { remove_staging_on_signals(); }

bool StopRequest::is_made() const { return is_requested != 0; }

void StopRequest::wait() const {
  constexpr std::chrono::milliseconds poll{50};
  while (!is_made()) std::this_thread::sleep_for(poll);
}

}  // namespace symscene::app
