// `symscene stitch`, run as a process.
#include "cli/small_scene.hpp"

namespace symscene::testing {
namespace {

TEST_F(Command, StitchesFramesToTheSameBytesForAnyNumberOfThreads) {
  write(file("arc.json"), R"({"camera": {"arc": 0.5, "radius": 0.7}})");
  ASSERT_EQ(run("simulate --sequence -o arc --frames 6 --seed 1 --config arc.json").code, 0);
  const Outcome one = run("stitch arc -o stitched1 --threads 1 --json");
  if (one.err.find("feature matcher") != std::string::npos) GTEST_SKIP() << one.err;
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(last_line(one.out).at("placed"), 6) << one.out;
  EXPECT_NE(one.err.find("6 placed; "), std::string::npos) << one.err;
  ASSERT_EQ(run("stitch arc -o stitched2 --threads 2").code, 0);
  for (const char* name : {"cloud.ply", "occupancy.bt", "mesh.ply", "poses.txt"}) {
    EXPECT_EQ(contents(file("stitched1") / name), contents(file("stitched2") / name)) << name;
  }
}

TEST_F(Command, RefusesFramesThatItCannotStitch) {
  const std::string given = " -o new --intrinsics 5,5,1.5,0.5";
  fs::create_directories(file("depths") / "depth");
  write(file("depths") / "depth/000000.png", depth_png);
  const Outcome depths = run("stitch depths" + given);
  if (depths.err.find("feature matcher") != std::string::npos) GTEST_SKIP() << depths.err;
  expect_refusal("stitch depths" + given, 1, "found 1 frames without colour");
  expect_refusal("stitch nowhere -o new", 1, "symscene stitch: nowhere");
  fs::create_directories(file("many") / "depth");
  fs::create_directories(file("many") / "color");
  for (int i = 0; i < 130; ++i) {
    const std::string name = std::to_string(1000000 + i).substr(1) + ".png";
    write(file("many") / "depth" / name, depth_png);
    write(file("many") / "color" / name, depth_png);
  }
  expect_refusal("stitch many" + given, 1, "at most 60 frames with colour (pass --every 3)");
  write(file("apart.json"), R"({"camera": {"width": 160, "height": 120, "focal_length": 130}})");
  ASSERT_EQ(run("simulate --sequence -o apart --frames 2 --seed 1 --config apart.json").code, 0);
  expect_refusal("stitch apart -o new --quiet", 1, "two frames that show the same textured");
  EXPECT_FALSE(fs::exists(file("new")));
}

}  // namespace
}  // namespace symscene::testing
