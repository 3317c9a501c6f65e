#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <tbb/global_control.h>

namespace symscene {

/// Threads that loops inside loops may start together.
inline constexpr std::size_t most_std_threads = 4;

/// Runs body(i) for i in [0, count) on threads of its own: slow, but the thread sanitizer sees all
/// synchronisation, of which oneTBB hides some. Rethrows an exception of a body.
template <class Body>
void for_each_on_std_threads(std::size_t count, const Body& body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::lock_guard lock(failing);
        failure = std::current_exception();
        next = count;
      }
    }
  };
  const std::size_t allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  std::vector<std::thread> helpers;
  for (std::size_t k = 1; k < std::min({count, allowed, most_std_threads}); ++k)
    helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace symscene
