#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include <tbb/global_control.h>

#include "core/random_clouds.hpp"
#include "symscene/core/thread_limit.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

double sum_of(const Points& points) {
  return reduce_blocks(
      static_cast<std::size_t>(points.rows()), 128, 0.0,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i)
          sum += static_cast<double>(points(static_cast<Eigen::Index>(i), 0));
        return sum;
      },
      [](double a, double b) { return a + b; });
}

TEST(ReduceBlocks, GivesTheSameBitsForAnyNumberOfThreads) {
  const Points points = testing::random_points(1, 100'003);
  std::vector<double> sums;
  for (const std::size_t threads : {1U, 2U, 8U}) {
    sums.push_back(testing::with_threads(threads, [&] { return sum_of(points); }));
  }
  EXPECT_EQ(sums[0], sums[1]);
  EXPECT_EQ(sums[0], sums[2]);
}

TEST(ReduceBlocks, OfNothingIsTheIdentity) { EXPECT_EQ(sum_of(Points(0, 3)), 0.0); }

TEST(ParallelForBlocks, VisitsEveryIndexOnce) {
  for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 1000U}) {
    std::vector<std::atomic<int>> visits(count);
    parallel_for_blocks(count, 64, [&](std::size_t begin, std::size_t end) {
      EXPECT_LT(begin, end);
      EXPECT_EQ(begin % 64, 0U);
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    for (const auto& visit : visits) EXPECT_EQ(visit, 1);
  }
}

TEST(ParallelForEach, PassesOnTheExceptionOfItsBody) {
  const auto body = [](std::size_t i) {
    if (i == 17) throw std::runtime_error("seventeen");
  };
  EXPECT_THROW(parallel_for_each(100, body), std::runtime_error);
}

TEST(ThreadLimit, BoundsTheThreadsWhileItLives) {
  const auto threads = [] {
    return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  };
  const std::size_t before = threads();
  {
    const ThreadLimit limit(1);
    EXPECT_EQ(threads(), 1U);
  }
  {
    const ThreadLimit all(0);
    EXPECT_EQ(threads(), before);
  }
  EXPECT_EQ(threads(), before);
}

TEST(WithThreads, RunsOnMoreThreadsThanCores) {
  constexpr std::size_t enough = 3;
  std::mutex mutex;
  std::set<std::thread::id> seen;
  const auto all_here = [&] {
    const std::lock_guard lock(mutex);
    seen.insert(std::this_thread::get_id());
    return seen.size() >= enough;
  };
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  testing::with_threads(8, [&] {
    parallel_for_each(64, [&](std::size_t) {
      // Keep this thread busy until the others have started.
      while (!all_here() && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
  });
  EXPECT_GE(seen.size(), enough);
}

}  // namespace
}  // namespace symscene
