#pragma once

#include <tbb/task_arena.h>

#include "symscene/core/thread_limit.hpp"

namespace symscene::testing {

/// What `body` returns when `threads` threads share its parallel loops, however few cores there
/// are: a limit alone leaves oneTBB with a thread a core.
template <class Body>
auto with_threads(std::size_t threads, const Body& body) {
  const ThreadLimit limit(threads);
  tbb::task_arena arena(static_cast<int>(threads));
  return arena.execute(body);
}

}  // namespace symscene::testing
