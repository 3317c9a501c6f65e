// `symscene grasp` from outside: scenes, results, grippers and what it refuses.
#include "cli/small_scene.hpp"

namespace symscene::testing {
namespace {

class GraspCommand : public Command {
 protected:
  static nlohmann::json json_of(const std::string& name) {
    return nlohmann::json::parse(contents(file(name)));
  }
};

TEST_F(GraspCommand, FindsTheGraspsOfAScene) {
  const Outcome outcome = run("grasp scene -o grasps.json -v");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("objects have a grasp"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("candidates"), std::string::npos) << outcome.out;
  const auto json = json_of("grasps.json");
  EXPECT_EQ(json.at("version"), 1);
  EXPECT_EQ(json.at("gripper").at("name"), "panda");
  EXPECT_EQ(json.at("objects").size(), objects_without_times("result").at("objects").size());
  for (const auto& object : json.at("objects"))
    EXPECT_EQ(object.contains("reason"), object.at("grasps") == 0);
}

TEST_F(GraspCommand, OfAResultWithItsSceneIsThatOfTheScene) {
  ASSERT_EQ(run("grasp scene -o of_scene.json").code, 0);
  const Outcome outcome = run("grasp result --scene scene -o of_result.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto a = json_of("of_scene.json");
  const auto b = json_of("of_result.json");
  ASSERT_EQ(a.at("objects").size(), b.at("objects").size());
  for (std::size_t i = 0; i < a.at("objects").size(); ++i)
    EXPECT_EQ(a.at("objects").at(i).at("candidates"), b.at("objects").at(i).at("candidates"));
}

TEST_F(GraspCommand, WarnsThatAResultDoesNotTellWhatWasNeverSeen) {
  const Outcome outcome = run("grasp result -o grasps.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("never seen counts as free"), std::string::npos) << outcome.err;
}

TEST_F(GraspCommand, TakesTheGripperOfAFile) {
  write(file("hand.json"), R"({"name": "clamp", "kind": "parallel", "max_opening_m": 0.001,
    "finger_depth_m": 0.04, "palm_size_m": [0.05, 0.1, 0.08]})");
  const Outcome outcome = run("grasp result --gripper hand.json -o grasps.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = json_of("grasps.json");
  EXPECT_EQ(json.at("gripper").at("name"), "clamp");
  EXPECT_TRUE(json.at("grasps").empty());
  for (const auto& object : json.at("objects")) EXPECT_EQ(object.at("reason"), "too_wide");
}

TEST_F(GraspCommand, RefusesGrippersThatItCannotUse) {
  expect_refusal("grasp result -o new.json --gripper claw", 1, "panda, baxter, reflex");
  expect_refusal("grasp result -o new.json --gripper nowhere.json", 1, "nowhere.json");
  write(file("odd.json"), R"({"name": "odd", "kind": "parallel", "max_opening_m": 0.05,
    "min_opening_m": 0.06, "finger_depth_m": 0.04, "palm_size_m": [0.05, 0.1, 0.08]})");
  expect_refusal("grasp result -o new.json --gripper odd.json", 1, "more than min_opening_m");
}

TEST_F(GraspCommand, RefusesInputsThatItCannotUse) {
  expect_refusal("grasp nowhere -o new.json", 1, "nowhere");
  expect_refusal("grasp scene --scene scene -o new.json", 1, "a result folder as input");
  expect_refusal("grasp result -o result/grasps.json", 1, "outside the input");
}

}  // namespace
}  // namespace symscene::testing
