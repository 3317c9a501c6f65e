#include "symscene/viewer/run_page.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

#include "recorded_run.hpp"
#include "symscene/core/error.hpp"
#include "viewer/run_payload.hpp"

namespace symscene {
namespace {

using nlohmann::json;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST(RunPage, HoldsSolidsBeliefsEventsAndWhatWasLeft) {
  const json run = run_payload(carried_box(), "One box");
  EXPECT_EQ(run.at("title"), "One box");
  ASSERT_EQ(run.at("solids").size(), 6U);
  EXPECT_EQ(run.at("solids").at(1).at("kind"), "hand");
  EXPECT_EQ(run.at("solids").at(2).at("name"), "sugar");
  EXPECT_EQ(run.at("solids").at(2).at("surface").at("triangles").at("count"), 12);
  EXPECT_EQ(run.at("beliefs").at(0).at("objects").at(0).at("label"), "box 0.93");
  EXPECT_TRUE(run.at("beliefs").at(1).at("objects").empty());
  EXPECT_EQ(run.at("events").at(1).at("outcome"), "failure");
  EXPECT_EQ(run.at("left").at(0), "brick: out of reach");
}

TEST(RunPage, IsOneDocumentWithTextsOutOfTheMarkup) {
  const std::string hostile = "</script><script>alert(1)</script>";
  RunRecording run = carried_box();
  run.solids[2].name = run.events[0].text = run.left[0] = hostile;
  run.beliefs[0].objects[0].label = hostile;
  const std::string page = render_run_page(run, hostile);
  EXPECT_EQ(page.find("@@SYMSCENE"), std::string::npos);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
}

TEST(RunPage, AcceptsSolidsAndBeliefsWithoutASurface) {
  RunRecording run = carried_box();
  run.solids[0].mesh = {};
  run.beliefs[0].objects[0].mesh = {};
  const json payload = run_payload(run, "t");
  EXPECT_TRUE(payload.at("solids").at(0).at("surface").is_null());
  EXPECT_TRUE(payload.at("beliefs").at(0).at("objects").at(0).at("surface").is_null());
}

TEST(RunPage, AcceptsARunThatNeverBegan) {
  RunRecording run = carried_box();
  run.times.clear();
  run.poses.clear();
  EXPECT_EQ(run_payload(run, "t").at("solids").at(0).at("track").at("moments"), "");
}

TEST(RunPage, AcceptsASingleMomentWithoutSolids) {
  RunRecording run;
  run.times = {3.0};
  run.poses = {{}};
  EXPECT_NO_THROW(render_run_page(run, ""));
}

/// A corrugated square with 2 (side − 1)² triangles.
TriangleMesh corrugated(Index side) {
  TriangleMesh mesh;
  mesh.vertices.resize(side * side, 3);
  mesh.triangles.resize(2 * (side - 1) * (side - 1), 3);
  for (Index i = 0; i < side * side; ++i) {
    const auto [x, y] = std::pair{static_cast<float>(i % side), static_cast<float>(i / side)};
    mesh.vertices.row(i) << 0.001F * x, 0.001F * y, 0.01F * std::sin(0.1F * x);
  }
  Eigen::Index t = 0;
  for (Index a = 0; a + side < side * side; ++a) {
    if (a % side + 1 == side) continue;
    mesh.triangles.row(t++) << a, a + 1, a + side + 1;
    mesh.triangles.row(t++) << a, a + side + 1, a + side;
  }
  return mesh;
}

TEST(RunPage, ThinsLargeMeshes) {
  RunRecording run = carried_box();
  run.solids[0].mesh = corrugated(150);
  run.beliefs[0].objects[0].mesh = corrugated(150);
  const json payload = run_payload(run, "t");
  const json& solid = payload.at("solids").at(0).at("surface").at("triangles").at("count");
  EXPECT_LE(solid.get<int>(), 20'000);
  EXPECT_GE(solid.get<int>(), 2'000);
  const json& believed = payload.at("beliefs").at(0).at("objects").at(0);
  EXPECT_LE(believed.at("surface").at("triangles").at("count").get<int>(), 3'000);
}

struct Damage {
  const char* name;
  std::function<void(RunRecording&)> apply;
};

class RunPageRefuses : public testing::TestWithParam<Damage> {};

TEST_P(RunPageRefuses, ADamagedRecording) {
  RunRecording run = carried_box();
  GetParam().apply(run);
  EXPECT_THROW(render_run_page(run, "t"), InputError);
}

const Damage damages[] = {
    {"MomentWithoutPoses", [](RunRecording& run) { run.poses.pop_back(); }},
    {"SolidWithoutPose", [](RunRecording& run) { run.poses[7].pop_back(); }},
    {"PoseWithoutSolid", [](RunRecording& run) { run.solids.pop_back(); }},
    {"FallingTime", [](RunRecording& run) { run.times[3] = run.times[1]; }},
    {"InfiniteTime",
     [](RunRecording& run) { run.times.back() = std::numeric_limits<double>::infinity(); }},
    {"PoseNotFinite", [](RunRecording& run) { run.poses[2][1].translation().x() = not_a_number; }},
    {"PoseThatScales", [](RunRecording& run) { run.poses[2][1].linear() *= 1.1; }},
    {"PoseThatReflects", [](RunRecording& run) { run.poses[2][1].linear().col(0) *= -1.0; }},
    {"VertexNotFinite",
     [](RunRecording& run) {
       run.solids[4].mesh.vertices(1, 1) = std::numeric_limits<float>::quiet_NaN();
     }},
    {"TriangleWithoutVertex",
     [](RunRecording& run) { run.beliefs[0].objects[0].mesh.triangles(0, 0) = 8; }},
    {"BeliefsOutOfOrder", [](RunRecording& run) { run.beliefs[1].time = 0.0; }},
    {"EventNotInTime", [](RunRecording& run) { run.events[1].time = not_a_number; }},
};

INSTANTIATE_TEST_SUITE_P(RunPage, RunPageRefuses, testing::ValuesIn(damages),
                         [](const auto& each) { return std::string(each.param.name); });

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(RunPage, IsWrittenAsAWholeOrNotAtAll) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "symscene_run_page.html";
  RunRecording run = carried_box();
  write_run_page(path, run, "t");
  const std::string written = contents(path);
  EXPECT_EQ(written, render_run_page(run, "t"));
  run.poses.pop_back();
  EXPECT_THROW(write_run_page(path, run, "t"), InputError);
  EXPECT_EQ(contents(path), written);
  EXPECT_THROW(write_run_page(path / "page.html", carried_box(), "t"), InputError);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace symscene
