#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>

// Takes the place of oneTBB's header in builds with SYMSCENE_STD_THREADS: loops run on threads of
// their own. Slow, but the thread sanitizer sees all synchronisation, of which oneTBB hides some.
namespace tbb {

struct simple_partitioner {};

/// Threads of one loop; loops inside loops start more.
inline constexpr std::size_t most_std_threads = 4;

/// Runs body on each part of `range`, one of its grain size at a time. Rethrows an exception of a
/// body.
template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body, simple_partitioner) {
  const std::size_t grain = range.grainsize();
  const std::size_t count = (range.size() + grain - 1) / grain;
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        const Value begin = range.begin() + static_cast<Value>(i * grain);
        body(blocked_range<Value>(begin, std::min<Value>(begin + grain, range.end()), grain));
      } catch (...) {
        const std::lock_guard lock(failing);
        failure = std::current_exception();
        next = count;
      }
    }
  };
  const std::size_t allowed = global_control::active_value(global_control::max_allowed_parallelism);
  std::vector<std::thread> helpers;
  for (std::size_t k = 1; k < std::min({count, allowed, most_std_threads}); ++k)
    helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tbb
