#include "symscene/core/thread_limit.hpp"

#include <tbb/global_control.h>

namespace symscene {
namespace {

constexpr auto parallelism = tbb::global_control::max_allowed_parallelism;

}  // namespace

struct ThreadLimit::Control {
  tbb::global_control tbb;
};

ThreadLimit::ThreadLimit(std::size_t threads)
    : control_(new Control{
          {parallelism, threads == 0 ? tbb::global_control::active_value(parallelism) : threads}}) {
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace symscene
