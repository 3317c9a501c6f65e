// `symscene pick --simulate` from outside.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace symscene::testing {
namespace {

/// A look of a few small images, to be quick.
constexpr const char* short_run =
    R"({"max_looks": 1, "empty_looks": 1, "look": {"frames": 12,
        "width": 320, "height": 240, "focal_length": 210},
        "video": {"width": 96, "height": 72}})";

#ifdef SYMSCENE_HAS_GIF
constexpr bool has_gif = true;
#else
constexpr bool has_gif = false;
#endif

class PickCommand : public ::testing::Test {
 protected:
  Outcome run(const std::string& arguments) const { return workspace_.run("pick " + arguments); }

  void expect_refusal(const std::string& arguments, const std::string& part) const {
    const Outcome outcome = run(arguments);
    EXPECT_NE(outcome.code, 0) << arguments;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(workspace_ / "run")) << arguments;
  }

  Workspace workspace_;
};

TEST_F(PickCommand, RefusesWhatItCannotDo) {
  expect_refusal("-o run", "--simulate");
  if (run("--simulate -o run --config none.json").err.find("libmujoco-dev") != std::string::npos)
    GTEST_SKIP() << "skipped: no physics in this build";
  expect_refusal("--simulate --robot puma -o run", "panda");
  expect_refusal("--simulate --objects nowhere -o run", "nowhere");
  expect_refusal("--simulate --count 0 -o run", "--count");
  expect_refusal("--simulate --video run.webm -o run", ".gif");
  write(workspace_ / "bad.json", R"({"look": {"min_radius": 2.0}})");
  expect_refusal("--simulate --config bad.json -o run", "min_radius");
}

TEST_F(PickCommand, WritesWhatBecameOfEveryObjectAndAPage) {
  write(workspace_ / "short.json", short_run);
  const std::string video = has_gif ? " --video run.gif" : "";
  const Outcome outcome =
      run("--simulate --count 1 --seed 3 --config short.json -o run -v" + video);
  if (outcome.err.find("-dev") != std::string::npos) GTEST_SKIP() << "skipped: " << outcome.err;
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(contents(workspace_ / "run" / "run.json"));
  EXPECT_EQ(json.at("objects"), 1);
  EXPECT_EQ(json.at("looks").size(), 1U);
  EXPECT_EQ(json.at("in_bin").get<int>() + static_cast<int>(json.at("left").size()), 1);
  for (const auto& left : json.at("left")) EXPECT_FALSE(left.at("reason").empty());
  EXPECT_NE(outcome.out.find("1 object"), std::string::npos) << outcome.out;
  const std::string page = contents(workspace_ / "run" / "page.html");
  EXPECT_NE(page.find("</html>"), std::string::npos);
  if (!has_gif) return;
  const std::string gif = contents(workspace_ / "run.gif");
  EXPECT_EQ(gif.substr(0, 6), "GIF89a");
  EXPECT_EQ(gif.substr(6, 4), std::string("\x60\0\x48\0", 4)) << "96 by 72 pixels";
}

}  // namespace
}  // namespace symscene::testing
