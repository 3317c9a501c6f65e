// symscene dataset, run as a process: new, continued and refused datasets.
#include <gtest/gtest.h>

#include <map>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace symscene::testing {
namespace {

/// Few frames of small images and arranged objects, so that a scene takes seconds.
constexpr const char* small = R"({"max_objects": 2, "arranged_every": 1, "camera": {"frames": 6,
  "arc": 0.05, "radius": 0.7, "width": 320, "height": 240, "focal_length": 262}})";

/// Every file under a folder and its bytes.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).string()] = contents(entry.path());
  }
  return files;
}

class DatasetCommand : public ::testing::Test {
 protected:
  void SetUp() override { write(workspace / "small.json", small); }

  Outcome make(const std::string& name, const std::string& more = "") const {
    return workspace.run("dataset " + name + " --scenes 2 --config small.json " + more);
  }

  static void expect_refusal(const Outcome& outcome, const std::string& sentence) {
    EXPECT_EQ(outcome.code, sentence.starts_with("--") ? 2 : 1) << outcome.err;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }

  Workspace workspace;
};

TEST_F(DatasetCommand, RecordsWhatAVariedSceneDrew) {
  write(workspace / "varied.json", R"({"max_objects": 2, "arranged_every": 1,
    "camera": {"width": 320, "height": 240, "focal_length": 262},
    "variation": {"enabled": true, "cameras": false, "single_views": 1, "few_views": 0, "stereo": 0,
                  "tof": 1, "min_distance": 0.6, "max_distance": 0.6, "max_elevation": 0.8}})");
  const Outcome made = workspace.run("dataset varied --scenes 1 --config varied.json");
  ASSERT_EQ(made.code, 0) << made.err;
  const auto drawn =
      nlohmann::json::parse(contents(workspace / "varied/scenes/0000/scene.json")).at("drawn");
  EXPECT_EQ(drawn.at("sensor"), "tof");
  EXPECT_EQ(drawn.at("frames"), 1);
  EXPECT_EQ(drawn.at("poses"), "exact");
  EXPECT_EQ(drawn.at("width"), 320);
  EXPECT_GE(drawn.at("distance").get<double>(), 0.6);
}

TEST_F(DatasetCommand, MakesTheSameBytesForAnyNumberOfProcessesAndContinues) {
  const Outcome made = make("one", "--threads 1 -v");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("2 scenes, 2 made now"), std::string::npos) << made.out;
  EXPECT_NE(made.out.find("reconstruct"), std::string::npos) << made.out;
  const auto files = files_in(workspace / "one");
  EXPECT_EQ(files.size(), 11U);
  for (const char* file : {"dataset.json", "scenes/0001/cloud.ply", "scenes/0001/occupancy.bt",
                           "scenes/0001/table_plane.txt", "scenes/0001/truth.json"})
    EXPECT_EQ(files.count(file), 1U) << file;
  ASSERT_EQ(make("two", "--threads 2").code, 0);
  EXPECT_EQ(files_in(workspace / "two"), files);

  const auto written = fs::last_write_time(workspace / "one" / "scenes" / "0001" / "cloud.ply");
  fs::remove_all(workspace / "one" / "scenes" / "0000");
  const Outcome resumed = make("one", "--json");
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("1 of 2 scenes exist already"), std::string::npos) << resumed.err;
  EXPECT_NE(resumed.out.find(R"("made":1)"), std::string::npos) << resumed.out;
  EXPECT_EQ(files_in(workspace / "one"), files);
  EXPECT_EQ(fs::last_write_time(workspace / "one" / "scenes" / "0001" / "cloud.ply"), written);
  EXPECT_NE(make("one").out.find("0 made now"), std::string::npos);

  const auto scene = nlohmann::json::parse(files.at("scenes/0000/scene.json"));
  EXPECT_EQ(scene.at("split"), "test");
  EXPECT_EQ(scene.at("frames").at("count"), 6);

  expect_refusal(make("one", "--seed 2"), "options/seed 1 in place of 2");
  expect_refusal(make("one", "--split training"), "split \"test\" in place of \"training\"");
  EXPECT_EQ(files_in(workspace / "one"), files);

  // A scene without ground truth is made again, and a dataset may grow but not shrink.
  fs::remove(workspace / "one" / "scenes" / "0000" / "truth.json");
  ASSERT_EQ(make("one").code, 0);
  EXPECT_EQ(files_in(workspace / "one"), files);
  const auto grown = workspace.run("dataset one --scenes 3 --config small.json");
  ASSERT_EQ(grown.code, 0) << grown.err;
  EXPECT_NE(grown.out.find("2 of 3 scenes exist already"), std::string::npos) << grown.out;
  auto longer = files_in(workspace / "one");
  EXPECT_EQ(longer.at("scenes/0001/cloud.ply"), files.at("scenes/0001/cloud.ply"));
  EXPECT_EQ(longer.count("scenes/0002/truth.json"), 1U);
  expect_refusal(make("one"), "options/scenes 3 in place of 2");
  fs::remove_all(workspace / "one" / "scenes" / "0002");

  fs::remove_all(workspace / "one" / "scenes" / "0001");
  const Outcome info = workspace.run("info one --json");
  ASSERT_EQ(info.code, 0) << info.err;
  const auto facts = nlohmann::json::parse(info.out.substr(info.out.rfind("\n{") + 1));
  EXPECT_EQ(facts.at("kind"), "dataset");
  EXPECT_EQ(facts.at("split"), "test");
  EXPECT_EQ(facts.at("scenes"), 1);
  EXPECT_EQ(facts.at("missing"), nlohmann::json::array({"0001", "0002"}));
  EXPECT_GE(facts.at("objects"), 1);
}

TEST_F(DatasetCommand, MakesScenesOfASingleFrame) {
  const Outcome made = make("look", "--frames 1");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.out.find("2 scenes, 2 made now"), std::string::npos) << made.out;
  const auto scene =
      nlohmann::json::parse(files_in(workspace / "look").at("scenes/0001/scene.json"));
  EXPECT_EQ(scene.at("frames").at("count"), 1);
  EXPECT_EQ(scene.at("frames").at("fused"), 1);
  EXPECT_EQ(make("none", "--frames 0").code, 2);
}

TEST_F(DatasetCommand, NamesTheScenesThatCouldNotBeMade) {
  write(workspace / "dark.json", R"({"arranged_every": 1, "attempts": 1,
    "camera": {"frames": 3, "width": 80, "height": 60, "focal_length": 65},
    "sensor": {"max_depth": 0.05}})");
  const Outcome outcome = workspace.run("dataset dark --scenes 2 --config dark.json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("scene 0001: no seed made a good scene"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("dark: expected 2 scenes, found 0"), std::string::npos) << outcome.err;
  EXPECT_EQ(files_in(workspace / "dark").size(), 1U);
}

TEST_F(DatasetCommand, RefusesInvalidInputInOneSentence) {
  fs::create_directories(workspace / "other");
  write(workspace / "other" / "letter.txt", "dear");
  expect_refusal(make("other"), "found a folder with other files");
  expect_refusal(make("small.json"), "found a file");
  expect_refusal(make("new", "--symmetries small.json"), "--symmetries: expected --meshes");
  expect_refusal(make("new", "--meshes nowhere"), "nowhere: expected a folder of meshes");
  expect_refusal(make("new", "--min-objects 3"), "max_objects");
  EXPECT_FALSE(fs::exists(workspace / "new"));
  EXPECT_EQ(workspace.run("dataset new --split both").code, 2);
}

}  // namespace
}  // namespace symscene::testing
