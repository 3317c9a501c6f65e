#include "progress.hpp"

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

namespace symscene::app {
namespace {

constexpr std::chrono::milliseconds delay{1000};
constexpr std::chrono::milliseconds interval{120};
constexpr const char* spinner = "|/-\\";

}  // namespace

bool stderr_is_terminal() { return isatty(STDERR_FILENO) != 0; }

Progress::Progress(bool enabled) {
  if (enabled) painter_ = std::jthread([this](const std::stop_token& stop) { draw_until(stop); });
}

Progress::~Progress() { stop(); }

void Progress::stop() {
  if (!painter_.joinable()) return;
  painter_.request_stop();
  painter_.join();
  const std::scoped_lock lock(mutex_);
  erase();
}

void Progress::begin(const std::string& stage) {
  const std::scoped_lock lock(mutex_);
  stage_ = stage;
}

void Progress::print_line(const std::string& line) {
  const std::scoped_lock lock(mutex_);
  erase();
  fmt::print(stderr, "{}\n", line);
}

void Progress::draw_until(const std::stop_token& stop) {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  auto next = start + delay;
  for (std::size_t tick = 0; !wake_.wait_until(lock, stop, next, [] { return false; }); ++tick) {
    if (stop.stop_requested()) return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    fmt::print(stderr, "\r{} {:.0f} s  {}\x1b[K", spinner[tick % 4], elapsed.count(), stage_);
    std::fflush(stderr);
    drawn_ = true;
    next = std::chrono::steady_clock::now() + interval;
  }
}

void Progress::erase() {
  if (drawn_) fmt::print(stderr, "\r\x1b[K");
  drawn_ = false;
}

}  // namespace symscene::app
