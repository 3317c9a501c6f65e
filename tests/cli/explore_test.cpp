// `symscene explore --simulate` from outside.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/json_schema.hpp"

namespace symscene::testing {
namespace {

class ExploreCommand : public ::testing::Test {
 protected:
  Outcome run(const std::string& arguments) const { return workspace_.run("explore " + arguments); }

  void expect_refusal(const std::string& arguments, int code, const std::string& part) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(workspace_ / "out")) << arguments;
  }

  nlohmann::json exploration() const {
    return nlohmann::json::parse(contents(workspace_ / "out" / "exploration.json"));
  }

  Workspace workspace_;
};

TEST_F(ExploreCommand, RefusesWhatItCannotDo) {
  expect_refusal("-o out", 2, "--simulate");
  expect_refusal("--simulate -o out --policy nearest", 2, "--policy");
  expect_refusal("--simulate -o out --views 0", 2, "--views");
  expect_refusal("--simulate -o out --scene heap", 2, "--scene");
  write(workspace_ / "bad.json", R"({"radius": -1.0})");
  expect_refusal("--simulate -o out --config bad.json", 1, "radius");
  const Outcome outcome = run("--simulate -o out --objects nowhere");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(outcome.err.find("nowhere") != std::string::npos ||
              outcome.err.find("libmujoco-dev") != std::string::npos)
      << outcome.err;
}

TEST_F(ExploreCommand, WritesWhatWasKnownAfterEachViewAndTheLastSceneAndResult) {
  const Outcome outcome = run("--simulate --count 1 --views 2 -o out -v");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = exploration();
  EXPECT_EQ(JsonSchema("exploration.schema.json").violation(json), "");
  ASSERT_GE(json.at("views").size(), 1U);
  EXPECT_TRUE(json.at("views").at(0).at("gain").is_null());
  EXPECT_EQ(json.at("candidates").size(), 34U);
  EXPECT_NE(outcome.out.find("view 1 from candidate 18"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("left unknown"), std::string::npos) << outcome.out;
  EXPECT_NE(contents(workspace_ / "out" / "page.html").find("</html>"), std::string::npos);
  const Outcome grasps = workspace_.run("grasp out/result --scene out/scene -o grasps.json");
  EXPECT_EQ(grasps.code, 0) << grasps.err;
  const Outcome next = workspace_.run("next-view out/scene -o views.json");
  EXPECT_EQ(next.code, 0) << next.err;
}

TEST_F(ExploreCommand, ReplacesItsFolderAndNoOther) {
  write(workspace_ / "few.json", R"({"choice": {"min_share": 1.0}})");
  const std::string arguments = "--simulate --count 1 --policy fixed-arc --config few.json -o out";
  ASSERT_EQ(run(arguments + " --json").code, 0);
  const Outcome again = run(arguments + " --json");
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(nlohmann::json::parse(again.out).at("end"), "enough");
  EXPECT_EQ(JsonSchema("exploration.schema.json").violation(exploration()), "");
  write(workspace_ / "out" / "notes.txt", "mine\n");
  EXPECT_NE(run(arguments).code, 0);
  EXPECT_EQ(contents(workspace_ / "out" / "notes.txt"), "mine\n");
}

}  // namespace
}  // namespace symscene::testing
