#include "picking/left_reasons.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(LeftReasons, AnObjectThatWasNotFoundSaysSo) {
  EXPECT_TRUE(contains(reason_left(std::nullopt, {}), "not found"));
}

TEST(LeftReasons, AnObjectWithoutGraspSaysWhichBoundItFails) {
  BeliefFate fate;
  fate.no_grasp = GraspRejection::too_wide;
  EXPECT_TRUE(contains(reason_left(fate, {}), description(GraspRejection::too_wide)));
}

TEST(LeftReasons, OfGraspsThatCannotBeTakenTheMostFrequentReasonIsTold) {
  BeliefFate fate;
  fate.grasps = 3;
  fate.rejected = {{0, PickRejection::too_far, {}},
                   {1, PickRejection::collision, "link5 meets object 2"},
                   {2, PickRejection::collision, "gripper meets object 1"}};
  const std::string reason = reason_left(fate, {});
  EXPECT_TRUE(contains(reason, description(PickRejection::collision)));
  EXPECT_TRUE(contains(reason, "link5 meets object 2"));
  EXPECT_FALSE(contains(reason, description(PickRejection::too_far)));
}

TEST(LeftReasons, FailedAttemptsAreCountedAndTheLastIsTold) {
  std::vector<PickAttempt> attempts(2);
  attempts[1].end = AttemptEnd::dropped;
  const std::string reason = reason_left(std::nullopt, attempts);
  EXPECT_TRUE(contains(reason, "2 failed attempts"));
  EXPECT_TRUE(contains(reason, description(AttemptEnd::dropped)));
}

}  // namespace
}  // namespace symscene
