#include "symscene/core/stage_timer.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace symscene {
namespace {

TEST(StageTimer, ListsStagesInOrderAndAnnouncesThem) {
  std::vector<std::string> announced;
  StageTimer timer([&](const std::string& stage) { announced.push_back(stage); });
  EXPECT_EQ(timer.time("load", [] { return 42; }), 42);
  timer.time("cut", [] {});
  ASSERT_EQ(timer.stages().size(), 2U);
  EXPECT_EQ(timer.stages()[0].stage, "load");
  EXPECT_EQ(timer.stages()[1].stage, "cut");
  EXPECT_GE(timer.stages()[0].seconds, 0.0);
  EXPECT_EQ(timer.total(), timer.stages()[0].seconds + timer.stages()[1].seconds);
  EXPECT_EQ(announced, (std::vector<std::string>{"load", "cut"}));
}

TEST(StageTimer, SumsTimesOfOneStage) {
  std::vector<StageTime> sums;
  for (const StageTime& time : {StageTime{"cut", 1.0}, {"load", 2.0}, {"cut", 4.0}})
    add_to_sums(sums, time);
  ASSERT_EQ(sums.size(), 2U);
  EXPECT_EQ(sums[0].stage, "cut");
  EXPECT_EQ(sums[0].seconds, 5.0);
  EXPECT_EQ(sums[1].seconds, 2.0);
}

TEST(StageTimer, ReturnsReferencesAsReferences) {
  StageTimer timer;
  int value = 1;
  timer.time("touch", [&]() -> int& { return value; }) = 2;
  EXPECT_EQ(value, 2);
}

TEST(StageTimer, CountsAStageThatThrew) {
  StageTimer timer;
  EXPECT_THROW(timer.time("fail", [] { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(timer.stages().size(), 1U);
}

}  // namespace
}  // namespace symscene
