#include "symscene/exploration/exploration_report.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

/// An exploration whose completed share is `share` after each of two views.
Exploration flat(int scene, ExplorationPolicy policy, double share) {
  ExplorationStep step;
  step.completed = share;
  step.observed = 0.5 * share;
  return {"packed", scene, policy, {step, step}};
}

TEST(PairedDifference, OfEqualDifferencesHasNoWidth) {
  const PairedDifference d = paired_difference(std::vector<double>(7, 0.25));
  EXPECT_EQ(d.mean, 0.25);
  EXPECT_EQ(d.low, 0.25);
  EXPECT_EQ(d.high, 0.25);
  EXPECT_EQ(d.scenes, 7U);
  EXPECT_EQ(paired_difference({}).scenes, 0U);
}

TEST(PairedDifference, EnclosesTheMeanAndNarrowsWithScenes) {
  std::vector<double> few{-1.0, 1.0, -1.0, 1.0}, many;
  for (int k = 0; k < 25; ++k) many.insert(many.end(), few.begin(), few.end());
  const PairedDifference a = paired_difference(few), b = paired_difference(many);
  EXPECT_LT(a.low, a.mean);
  EXPECT_GT(a.high, a.mean);
  EXPECT_LT(b.high - b.low, 0.5 * (a.high - a.low));
}

TEST(ExplorationReport, TellsTheDifferenceOfTheReference) {
  std::vector<Exploration> all;
  for (int scene = 0; scene < 4; ++scene) {
    all.push_back(flat(scene, ExplorationPolicy::symmetry, 0.9));
    all.push_back(flat(scene, ExplorationPolicy::random, 0.6));
  }
  const std::string report = format_exploration_report(all);
  EXPECT_NE(report.find("4 scenes"), std::string::npos);
  EXPECT_NE(report.find("+0.300 (95 % interval +0.300 to +0.300), +50.0 %"), std::string::npos)
      << report;
}

TEST(ExplorationReport, LeavesOutScenesThatAPolicyDidNotFinish) {
  std::vector<Exploration> all{
      flat(0, ExplorationPolicy::symmetry, 0.9), flat(0, ExplorationPolicy::random, 0.6),
      flat(1, ExplorationPolicy::symmetry, 0.9), flat(1, ExplorationPolicy::random, 0.6)};
  all[3].steps.pop_back();
  EXPECT_NE(format_exploration_report(all).find("1 scenes"), std::string::npos);
  EXPECT_EQ(format_exploration_report({}), "no scene\n");
}

TEST(ExplorationReport, WritesALinePerView) {
  const std::vector<Exploration> one{flat(7, ExplorationPolicy::oracle, 0.5)};
  const std::string csv = format_explorations_csv(one);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_NE(csv.find("packed,7,oracle,2,0,0.2500,0.5000,0,0,0,0,0,0,0,0,0,,0.0000"),
            std::string::npos)
      << csv;
}

}  // namespace
}  // namespace symscene
