#include "core/without_repeats.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace symscene {
namespace {

TEST(WithoutRepeats, KeepsTheFirstOfEachAndComparesOnlyWithKeptOnes) {
  const auto near = [](double a, double b) { return std::abs(a - b) < 1.0; };
  // 0.9 repeats 0; 1.8 would repeat 0.9, which is not kept.
  EXPECT_EQ(without_repeats(std::vector{0.0, 0.9, 1.8, 0.1, 5.0}, near),
            (std::vector{0.0, 1.8, 5.0}));
  EXPECT_TRUE(without_repeats(std::vector<double>{}, near).empty());
}

}  // namespace
}  // namespace symscene
