#include "grasping/sorted_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace symscene {
namespace {

TEST(SortedOrder, EqualsAStableSort) {
  std::mt19937_64 random(1);
  for (const std::uint64_t range : {1ULL, 7ULL, 1ULL << 13U, 1ULL << 40U, ~0ULL}) {
    std::vector<std::uint64_t> keys(500);
    for (std::uint64_t& key : keys) key = random() % range;
    std::vector<Index> expected(keys.size());
    std::iota(expected.begin(), expected.end(), 0U);
    std::ranges::stable_sort(expected, {}, [&](Index i) { return keys[i]; });
    EXPECT_EQ(sorted_order(keys), expected);
  }
  EXPECT_TRUE(sorted_order({}).empty());
}

}  // namespace
}  // namespace symscene
