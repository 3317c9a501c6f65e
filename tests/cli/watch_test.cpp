// `symscene watch`, run as a process, without its server: tests/viewer/live_page.mjs has that.
#include <sstream>

#include "cli/small_sweep.hpp"

namespace symscene::testing {
namespace {

using nlohmann::json;

class Watch : public SweepCommand {
 protected:
  static std::vector<json> lines_of(const std::string& text) {
    std::vector<json> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(json::parse(line));
    return lines;
  }

  static json objects_in(const std::string& folder) {
    return json::parse(contents(file(folder) / "objects.json")).at("objects");
  }
};

TEST_F(Watch, TellsEachUpdateAndWritesTheLastAsAResult) {
  const Outcome watched = run("watch sweep --no-server --fast --poses exact -o live --json");
  ASSERT_EQ(watched.code, 0) << watched.err;
  const std::vector<json> lines = lines_of(watched.out);
  ASSERT_GE(lines.size(), 2U);
  const json &last = lines[lines.size() - 2], &summary = lines.back();
  EXPECT_EQ(last.at("frames"), frames);
  EXPECT_EQ(summary.at("frames"), frames);
  EXPECT_EQ(summary.at("lost"), 0);
  EXPECT_EQ(summary.at("updates"), lines.size() - 1);
  std::size_t before = 0;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    EXPECT_EQ(lines[i].at("update"), i + 1);
    EXPECT_GT(lines[i].at("frames"), before);
    EXPECT_GT(lines[i].at("latency"), 0.0);
    before = lines[i].at("frames");
  }
  const json objects = objects_in("live");
  EXPECT_GT(objects.size(), 3U);
  EXPECT_EQ(last.at("objects").size(), objects.size());
}

TEST_F(Watch, OfASceneAtRestFindsAtTheEndWhatReconstructAndSegmentFind) {
  write(file("rest.json"), R"({"tsdf": {"max_contradicted_looks": 0}})");
  const std::string at_rest = "watch sweep --no-server --fast --poses exact --config rest.json";
  ASSERT_EQ(run(at_rest + " -o live").code, 0);
  ASSERT_EQ(run("reconstruct sweep --poses exact -o placed").code, 0);
  ASSERT_EQ(run("segment placed -o found").code, 0);
  const json live = objects_in("live"), found = objects_in("found");
  ASSERT_EQ(live.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto points = static_cast<double>(found[i].at("points").size());
    EXPECT_NEAR(static_cast<double>(live[i].at("points").size()), points, 0.05 * points + 5) << i;
  }
}

TEST_F(Watch, LeavesOutFramesBeforeTheFirstPoseAndRefusesToUsePosesThatAreNotThere) {
  // As a folder of TUM RGB-D, where poses begin two frames after the images.
  fs::create_directories(file("late"));
  fs::copy(file("sweep") / "depth", file("late") / "depth", fs::copy_options::recursive);
  std::istringstream poses(contents(file("sweep") / "poses.txt"));
  std::string images, later;
  int frame = 0;
  for (std::string line; std::getline(poses, line); ++frame) {
    images += line.substr(0, line.find(' ')) + " " + image(frame) + "\n";
    if (frame >= 2) later += line + "\n";
  }
  write(file("late") / "depth.txt", images);
  write(file("late") / "groundtruth.txt", later);
  const std::string camera = " --intrinsics 262,262,159.5,119.5 --depth-scale 1000";
  const Outcome watched = run("watch late --no-server --fast --poses exact --json" + camera);
  ASSERT_EQ(watched.code, 0) << watched.err;
  EXPECT_EQ(lines_of(watched.out).back().at("frames"), frames - 2);
  EXPECT_NE(watched.err.find("expected a pose with the first fused frame, found frame 1 without"),
            std::string::npos)
      << watched.err;

  fs::remove(copy_of_sweep("poseless") / "poses.txt");
  const Outcome poseless = run("watch poseless --no-server --fast --poses exact");
  EXPECT_EQ(poseless.code, 1);
  EXPECT_NE(poseless.err.find("expected poses, which --poses needs"), std::string::npos)
      << poseless.err;
}

TEST_F(Watch, RefusesFramesThatShowNothingAndOptionsThatContradict) {
  const Outcome dark = run("watch dark --no-server --fast -o new");
  EXPECT_EQ(dark.code, 1);
  EXPECT_NE(dark.err.find("expected"), std::string::npos) << dark.err;
  EXPECT_EQ(run("watch none --no-server -o new").code, 1);
  EXPECT_EQ(run("watch sweep --no-server --port 70000").code, 2);
  EXPECT_EQ(run("watch sweep --no-server --no-table --any-up -o new").code, 2);
  EXPECT_NE(run("watch sweep --token 'a&b' -o new").err.find("--token"), std::string::npos);
  EXPECT_FALSE(fs::exists(file("new")));
}

}  // namespace
}  // namespace symscene::testing
