// What reconstruct tells about its pace, and its advice about depth scales.
#include "frame_rate.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "depth_range.hpp"

namespace symscene::app {
namespace {

TEST(FrameRate, TellsPaceAndTimeLeftOnceItIsKnown) {
  EXPECT_EQ(frame_progress(0, 120, 0.0), "frame 1 of 120");
  EXPECT_EQ(frame_progress(5, 120, 0.5), "frame 6 of 120");
  EXPECT_EQ(frame_progress(20, 120, 2.0), "frame 21 of 120, 10.0 per second, 10 s left");
  EXPECT_EQ(frame_progress(1, 1000, 1.0), "frame 2 of 1000, 1.0 per second, 17 min left");
}

TEST(FrameRate, RoundsDurationsUp) {
  EXPECT_EQ(rough_duration(0.2), "1 s");
  EXPECT_EQ(rough_duration(100.0), "2 min");
  EXPECT_EQ(rough_duration(7200.0), "2.0 h");
}

DepthFrame frame_at(double depth) {
  DepthFrame frame;
  frame.depth.assign(100, static_cast<float>(depth));
  frame.depth.front() = 0.0F;
  return frame;
}

TEST(DepthRange, NamesMedianLimitAndTheScaleToTry) {
  // A table at 0.78 m in images of 5000 per metre that are read as millimetres.
  const DepthFrame frame = frame_at(3.9);
  const auto far = depth_range_warning({&frame, 1}, {1000.0, 0.2, 3.0});
  ASSERT_TRUE(far);
  EXPECT_EQ(*far,
            "100 % of the depths are outside 0.2 to 3 m and not used; the median depth is 3.9 m: "
            "try --depth-scale 5000, which makes it 0.78 m, in place of 1000");
  EXPECT_FALSE(depth_range_warning({&frame, 1}, {1000.0, 0.2, 6.0}));
}

TEST(DepthRange, AFarBackgroundIsNotTakenForAWrongScale) {
  const std::vector<DepthFrame> frames{frame_at(3.0), frame_at(3.0), frame_at(8.0)};
  const auto warning = depth_range_warning(frames, {1000.0, 0.2, 6.0});
  ASSERT_TRUE(warning);
  EXPECT_EQ(*warning,
            "33 % of the depths are outside 0.2 to 6 m and not used; the median depth is 3 m");
}

TEST(DepthRange, ATableLargerThanTablesAreIsTakenForAWrongScale) {
  const auto warning = large_table_warning(frame_at(3.9), 11.0, {200.0, 0.2, 6.0});
  ASSERT_TRUE(warning);
  EXPECT_EQ(*warning,
            "the table is 11 m^2 large at a median depth of 3.9 m: unless it is a floor, try "
            "--depth-scale 1000, which makes it 0.44 m^2 at 0.78 m");
}

TEST(DepthRange, ALargeTableIsNotDoubtedTwiceNorOneThatIsNear) {
  const DepthUse use{1000.0, 0.2, 6.0};
  EXPECT_FALSE(large_table_warning(frame_at(3.9), 5.0, use));
  EXPECT_FALSE(large_table_warning(frame_at(1.0), 11.0, use)) << "no other scale is likelier";
  EXPECT_TRUE(depth_range_warning(std::vector{frame_at(7.0)}, use));
  EXPECT_FALSE(large_table_warning(frame_at(7.0), 11.0, use)) << "already doubted by its range";
}

TEST(DepthRange, AdvisesAScaleWhereMostIsUsedButFarForATable) {
  const std::vector<DepthFrame> frames{frame_at(5.5), frame_at(5.5), frame_at(7.0)};
  const auto warning = depth_range_warning(frames, {1000.0, 0.2, 6.0});
  ASSERT_TRUE(warning);
  EXPECT_TRUE(
      warning->ends_with("unless it is a room, try --depth-scale 5000, which makes it 1.1 m"))
      << *warning;
}

TEST(DepthRange, FindsTheTrueScaleForEveryUsualMistake) {
  for (const double truth : {1.0, 1000.0, 5000.0, 10000.0}) {
    for (const double read_as : {1.0, 1000.0, 5000.0, 10000.0}) {
      const DepthFrame frame = frame_at(0.9 * truth / read_as);
      const auto warning = depth_range_warning({&frame, 1}, {read_as, 0.2, 6.0});
      if (!warning) continue;
      EXPECT_NE(warning->find("try --depth-scale " + std::to_string(static_cast<int>(truth)) + ","),
                std::string::npos)
          << *warning;
    }
  }
}

TEST(DepthRange, AsksWhereNoOtherScaleIsLikelier) {
  const DepthFrame frame = frame_at(0.6);
  const auto warning = depth_range_warning({&frame, 1}, {1000.0, 0.8, 6.0});
  ASSERT_TRUE(warning);
  EXPECT_NE(warning->find("is --depth-scale 1000 right?"), std::string::npos) << *warning;
}

}  // namespace
}  // namespace symscene::app
