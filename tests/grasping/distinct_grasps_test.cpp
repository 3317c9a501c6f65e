#include "grasping/distinct_grasps.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace symscene {
namespace {

Grasp grasp_at(double x, GraspSource source, double quality) {
  Grasp grasp;
  grasp.T_world_tool = Eigen::Translation3d(x, 0.0, 0.0);
  grasp.source = source;
  grasp.quality = quality;
  return grasp;
}

std::size_t count_of(const std::vector<Grasp>& grasps, GraspSource source) {
  return static_cast<std::size_t>(std::count_if(
      grasps.begin(), grasps.end(), [&](const Grasp& grasp) { return grasp.source == source; }));
}

TEST(DistinctGrasps, KeepTheBetterOfTwoThatNearlyCoincide) {
  const DistinctGrasps distinct = distinct_grasps(
      {grasp_at(0.001, GraspSource::antipodal, 0.8), grasp_at(0.0, GraspSource::antipodal, 0.9)},
      GripperKind::parallel, {});
  ASSERT_EQ(distinct.kept.size(), 1U);
  EXPECT_EQ(distinct.kept[0].quality, 0.9);
  EXPECT_EQ(distinct.outranked.size(), 1U);
}

TEST(DistinctGrasps, LeaveRoomForEveryGroupOfGrasps) {
  std::vector<Grasp> grasps;
  for (int i = 0; i < 30; ++i) grasps.push_back(grasp_at(0.1 * i, GraspSource::axis_side, 0.95));
  for (int i = 0; i < 3; ++i) grasps.push_back(grasp_at(-1.0 - i, GraspSource::antipodal, 0.7));
  const DistinctGrasps distinct = distinct_grasps(grasps, GripperKind::parallel, {});
  EXPECT_EQ(distinct.kept.size(), 20U);
  EXPECT_EQ(count_of(distinct.kept, GraspSource::antipodal), 3U);
  EXPECT_EQ(distinct.outranked.size(), 13U);
  for (std::size_t i = 1; i < distinct.kept.size(); ++i)
    EXPECT_GE(distinct.kept[i - 1].quality, distinct.kept[i].quality);
}

TEST(DistinctGrasps, OfAGroupAreNotReplacedByOneThatIsNotKept) {
  // The only antipodal one is near the best but one of the other group, which has room for one.
  GraspOptions options;
  options.max_grasps = 2;
  const DistinctGrasps distinct = distinct_grasps(
      {grasp_at(0.0, GraspSource::axis_side, 0.95), grasp_at(1.0, GraspSource::axis_side, 0.9),
       grasp_at(1.001, GraspSource::antipodal, 0.8)},
      GripperKind::parallel, options);
  EXPECT_EQ(count_of(distinct.kept, GraspSource::antipodal), 1U);
}

TEST(DistinctGrasps, AreNeverMoreThanAllowed) {
  GraspOptions options;
  options.max_grasps = 2;
  std::vector<Grasp> grasps;
  for (const GraspSource source :
       {GraspSource::axis_side, GraspSource::axis_top, GraspSource::rim, GraspSource::antipodal})
    grasps.push_back(grasp_at(static_cast<double>(grasps.size()), source, 0.9));
  EXPECT_EQ(distinct_grasps(grasps, GripperKind::parallel, options).kept.size(), 2U);
}

}  // namespace
}  // namespace symscene
