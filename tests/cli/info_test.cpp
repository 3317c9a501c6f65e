// `symscene info`, run as a process.
#include "cli/small_scene.hpp"

namespace symscene::testing {
namespace {

TEST_F(Command, DescribesAScene) {
  const Outcome described = run("info scene --json");
  ASSERT_EQ(described.code, 0) << described.err;
  for (const char* label : {"points", "box", "spacing", "occupancy", "table", "ground truth"})
    EXPECT_NE(("\n" + described.err).find(std::string("\n") + label), std::string::npos) << label;
  const auto line = last_line(described.out);
  EXPECT_EQ(line.at("kind"), "scene");
  EXPECT_GT(line.at("points"), 1000);
  EXPECT_EQ(line.at("true_objects"), 2);
  EXPECT_GT(line.at("occupancy").at("free"), line.at("occupancy").at("occupied"));
  EXPECT_EQ(run("info scene --quiet").out, "");
}

TEST_F(Command, DescribesAResult) {
  const auto objects = objects_without_times("result").at("objects");
  const auto line = last_line(run("info result --json").out);
  EXPECT_EQ(line.at("kind"), "result");
  EXPECT_EQ(line.at("objects"), objects.size());
  EXPECT_EQ(line.at("mask_sizes").at(0), objects.at(0).at("points").size());
}

TEST_F(Command, DescribesAModel) {
  EXPECT_EQ(last_line(run("info scene/cloud.ply --json").out).at("kind"), "cloud");
  EXPECT_EQ(last_line(run("info scene/occupancy.bt --json").out).at("kind"), "occupancy");
  write(file("one.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(last_line(run("info one.obj --json").out).at("mesh").at("triangles"), 1);
}

TEST_F(Command, DescribesASequenceAndItsUnreadableFrames) {
  fs::create_directories(file("sequence") / "depth");
  write(file("sequence") / "depth/000000.png", depth_png);
  write(file("sequence") / "depth/000001.png", depth_png.substr(0, 50));
  write(file("sequence") / "poses.txt", "1 0 0 0 0 0 0 1\n1.5 0 3 4 0 0 0 1\n");
  expect_refusal("info sequence", 1,
                 "pass --intrinsics fx,fy,cx,cy (or a camera.yaml), found none");
  expect_refusal("info sequence --intrinsics 1,2,3", 2, "expected fx,fy,cx,cy");
  expect_refusal("info sequence --depth-scale 0", 2,
                 "expected a number in [0.1, 1000000], found 0");
  const Outcome described = run("info sequence --json --intrinsics 5,5,1.5,0.5");
  ASSERT_EQ(described.code, 0) << described.err;
  EXPECT_NE(described.out.find("sequence/depth/000001.png: expected a whole PNG image"),
            std::string::npos)
      << described.out;
  const auto line = last_line(described.out);
  EXPECT_EQ(line.at("layout"), "sequence");
  EXPECT_EQ(line.at("frames"), 2);
  EXPECT_EQ(line.at("rate"), 2.0);
  EXPECT_EQ(line.at("camera").at("width"), 4);
  EXPECT_EQ(line.at("depth").at("median"), 1.003);
  EXPECT_EQ(line.at("depth").at("measured"), 0.875);
  EXPECT_EQ(line.at("path_length"), 5.0);
  EXPECT_EQ(line.at("unreadable").size(), 1U);
}

TEST_F(Command, RefusesToDescribeAnythingElse) {
  fs::create_directories(file("something"));
  expect_refusal("info something", 1, "found another folder");
  expect_refusal("info nowhere", 1, "found no such file or folder");
}

}  // namespace
}  // namespace symscene::testing
