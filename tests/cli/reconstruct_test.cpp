// symscene reconstruct, run as a process, on complete, broken and empty sequences.
#include <sstream>

#include "cli/small_sweep.hpp"

namespace symscene::testing {
namespace {

TEST_F(SweepCommand, WritesASceneThatInfoAndSegmentRead) {
  for (const char* name : {"cloud.ply", "mesh.ply", "occupancy.bt", "occupancy.ot",
                           "table_plane.txt", "poses.txt", "scene.json", "truth.json"}) {
    EXPECT_GT(fs::file_size(file("scene") / name), 10U) << name;
  }
  EXPECT_EQ(poses_of("scene"), std::size_t{frames});
  EXPECT_EQ(frames_of("scene").at("fused"), frames);
  EXPECT_EQ(frames_of("scene").at("lost"), 0);
  const Outcome described = run("info scene");
  EXPECT_EQ(described.code, 0) << described.err;
  const Outcome segmented = run("segment scene -o result");
  EXPECT_EQ(segmented.code, 0) << segmented.err;
  run("masks result sweep -o masks --every 4");  // replaced by the next
  const Outcome masks = run("masks result sweep -o masks --every 5");
  EXPECT_EQ(masks.code, 0) << masks.err;
  for (const char* name : {"labels/000000.png", "labels/000010.png", "overlays/000005.png"})
    EXPECT_GT(fs::file_size(file("masks") / name), 100U) << name;
  EXPECT_FALSE(fs::exists(file("masks") / "labels/000001.png"));
  EXPECT_NE(run("masks result dark -o sweep").code, 0);
}

TEST_F(SweepCommand, ReportsItsErrorAgainstThePosesOfTheSequence) {
  const std::size_t at = report().find("absolute error ");
  ASSERT_NE(at, std::string::npos) << report();
  EXPECT_LT(std::stod(report().substr(at + 15)), 5.0) << report();
}

TEST_F(SweepCommand, WritesTheSameBytesForAnyNumberOfThreads) {
  for (const char* threads : {"1", "2"}) {
    const std::string scene = std::string("threads") + threads;
    ASSERT_EQ(run("reconstruct sweep -o " + scene + " --threads " + threads).code, 0);
    for (const char* name : {"cloud.ply", "mesh.ply", "occupancy.bt", "occupancy.ot",
                             "table_plane.txt", "poses.txt", "truth.json"}) {
      EXPECT_EQ(contents(file(scene) / name), contents(file("scene") / name)) << name;
    }
  }
}

TEST_F(SweepCommand, StitchesFramesThatAreTooFarApartToBeTracked) {
  write(file("far.json"), R"({"tabletop": {"objects": 7}, "camera": {"frames": 8, "arc": 1.1,
      "radius": 0.7, "width": 320, "height": 240, "focal_length": 262}})");
  ASSERT_EQ(run("simulate --sequence -o far --config far.json").code, 0);
  const Outcome outcome = run("reconstruct far -o far_scene --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  if (outcome.err.find("stitching") == std::string::npos && run("stitch far -o no").code != 0)
    GTEST_SKIP() << "this build has no OpenCV";
  EXPECT_NE(outcome.err.find("placed by stitching, 8 of 8"), std::string::npos) << outcome.err;
  const nlohmann::json log = frames_of("far_scene");
  EXPECT_EQ(log.at("stitched"), 8);
  ASSERT_EQ(log.at("warnings").size(), 1U);
  EXPECT_NE(log.at("warnings")[0].get<std::string>().find("by stitching"), std::string::npos);
  const std::size_t at = outcome.err.find("absolute error ");
  ASSERT_NE(at, std::string::npos) << outcome.err;
  EXPECT_LT(std::stod(outcome.err.substr(at + 15)), 2.0) << outcome.err;
  EXPECT_FALSE(frames_of("scene").contains("stitched"));  // whose frames are close together
  EXPECT_FALSE(frames_of("scene").contains("warnings"));
}

TEST_F(SweepCommand, UsesThePosesOfTheSequence) {
  for (const char* use : {"exact", "start"}) {
    const Outcome outcome = run(std::string("reconstruct sweep -o posed --poses ") + use);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(poses_of("posed"), std::size_t{frames});
  }
  fs::remove(copy_of_sweep("poseless") / "poses.txt");
  expect_failure("poseless -o new --poses exact", 1, "expected poses, which --poses needs");
  expect_failure("poseless -o new --poses start", 1, "expected poses, which --poses needs");
  EXPECT_EQ(run("reconstruct poseless -o without").code, 0);
  expect_failure("sweep -o new --poses roughly", 2, "--poses");
}

TEST_F(SweepCommand, SkipsUnreadableFramesAndNamesThem) {
  const fs::path sequence = copy_of_sweep("cut");
  fs::resize_file(sequence / image(7), fs::file_size(sequence / image(7)) / 2);
  write(sequence / image(8), "not an image");
  const Outcome outcome = run("reconstruct cut -o patched");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("000007.png"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("000008.png"), std::string::npos) << outcome.err;
  EXPECT_EQ(frames_of("patched").at("unreadable"), 2);
  EXPECT_EQ(frames_of("patched").at("fused"), frames - 2);
  EXPECT_EQ(poses_of("patched"), std::size_t{frames - 2});
}

TEST_F(SweepCommand, SkipsBlackFramesAndContinuesAfterThem) {
  const fs::path sequence = copy_of_sweep("blinking");
  for (const int i : {0, 1, 8, 9}) {
    fs::copy_file(file("dark") / image(i), sequence / image(i),
                  fs::copy_options::overwrite_existing);
  }
  const Outcome outcome = run("reconstruct blinking -o blinked");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(frames_of("blinked").at("lost"), 4);
  EXPECT_EQ(frames_of("blinked").at("fused"), frames - 4);
  EXPECT_EQ(frames_of("blinked").at("relocalized"), 1);
  EXPECT_NE(outcome.out.find("too little of the image is measured"), std::string::npos);
}

TEST_F(SweepCommand, ReportsWhyNoFrameCanBeFused) {
  expect_failure("dark -o new", 1, "too little of the image is measured");
  const fs::path sequence = copy_of_sweep("ruin");
  for (int i = 0; i < frames; ++i) fs::resize_file(sequence / image(i), 30);
  expect_failure("ruin -o new", 1, "ruin");
}

TEST_F(SweepCommand, WritesNothingIfNoneOfManyFramesCanBeFused) {
  const fs::path sequence = copy_of_sweep("motley");
  for (int i = 0; i < frames; ++i) {
    fs::copy_file(file("dark") / image(i), sequence / image(i),
                  fs::copy_options::overwrite_existing);
    if (i % 2 != 0) fs::resize_file(sequence / image(i), 30);
  }
  const Outcome outcome = run("reconstruct motley -o new");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.err.find("scene.json"), std::string::npos) << "there is none\n" << outcome.err;
  EXPECT_FALSE(fs::exists(file("new")));
}

TEST_F(SweepCommand, UsesEveryNthFrameAndTellsItsRate) {
  const Outcome outcome = run("reconstruct sweep -o third --every 3 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find(" per second\n"), std::string::npos) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report.at("frames"), (frames + 2) / 3);
  EXPECT_GT(report.at("frames_per_second"), 0.0);
  const auto log = frames_of("third");
  EXPECT_EQ(log.at("every"), 3);
  EXPECT_EQ(log.at("runs").back().at("last"), 3 * ((frames + 2) / 3 - 1));
  const auto times = [](const std::string& scene) {
    std::istringstream poses(contents(file(scene) / "poses.txt"));
    std::vector<std::string> found;
    for (std::string line; std::getline(poses, line);)
      found.push_back(line.substr(0, line.find(' ')));
    return found;
  };
  ASSERT_EQ(times("third").size(), 4U);
  EXPECT_EQ(times("third")[1], times("scene")[3]);
}

TEST_F(SweepCommand, WritesBesideTheImagesOfItsInput) {
  const fs::path sweep = copy_of_sweep("inner");
  ASSERT_EQ(run("reconstruct inner -o inner/scene --every 4").code, 0);
  ASSERT_EQ(run("reconstruct inner -o ./inner/scene/ --every 4").code, 0);  // replaces it
  EXPECT_TRUE(fs::exists(sweep / "scene/cloud.ply"));
  EXPECT_NE(run("info inner --json").out.find("\"kind\":\"sequence\""), std::string::npos);
  for (const char* output : {"inner", "inner/", "inner/depth", "inner/depth/scene", "inner/color",
                             "inner/poses.txt", "inner/rgb"})
    expect_failure(std::string("inner -o ") + output, 1, "outside the input");
}

TEST_F(SweepCommand, SegmentSaysWhatToDoWithManyFrames) {
  const Outcome outcome = run("segment sweep -o new");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("run symscene reconstruct first"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_F(SweepCommand, WithoutATableEverythingIsWrittenAllTheSame) {
  const Outcome reconstructed = run("reconstruct sweep -o whole --no-table");
  ASSERT_EQ(reconstructed.code, 0) << reconstructed.err;
  EXPECT_EQ(reconstructed.err, "");
  EXPECT_FALSE(fs::exists(file("whole") / "table_plane.txt"));
  for (const char* written : {"cloud.ply", "mesh.ply", "poses.txt", "occupancy.bt"})
    EXPECT_GT(fs::file_size(file("whole") / written), 100U) << written;
  const Outcome both = run("reconstruct sweep -o new --no-table --plane 0,0,1,0");
  EXPECT_EQ(both.code, 2);
  // A plane that nothing is near does not cost the reconstruction.
  const Outcome aside = run("reconstruct sweep -o aside --plane 0,1,0,50");
  ASSERT_EQ(aside.code, 0) << aside.err;
  EXPECT_NE(aside.err.find("--plane: expected a plane with points on it"), std::string::npos)
      << aside.err;
  EXPECT_EQ(contents(file("aside") / "cloud.ply"), contents(file("whole") / "cloud.ply"));
}

/// A scene as `reconstruct` writes it of a table on which nothing stands.
TEST_F(SweepCommand, ABareTableKeepsItsSurface) {
  fs::copy(file("scene"), file("bare"), fs::copy_options::recursive);
  fs::remove(file("bare") / "occupancy.bt");
  write(file("bare") / "cloud.ply",
        "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
        "property float z\nend_header\n");
  const Outcome nothing = run("segment bare -o nothing --page nothing.html");
  ASSERT_EQ(nothing.code, 0) << nothing.err;
  EXPECT_EQ(nothing.err.find("occupancy.bt"), std::string::npos) << nothing.err;
  EXPECT_NE(nothing.err.find("the page shows no ground truth"), std::string::npos) << nothing.err;
  EXPECT_GT(fs::file_size(file("nothing") / "surface.ply"), 10000U);
  EXPECT_NE(contents(file("nothing.html")).find(R"("surface":{"colors")"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(contents(file("nothing") / "objects.json")).at("objects").size(),
            0U);
}

TEST_F(SweepCommand, SegmentFindsTheTableInACloud) {
  const Outcome whole = run("reconstruct sweep -o cloud_scene --no-table");
  ASSERT_EQ(whole.code, 0) << whole.err;
  const Outcome found = run("segment cloud_scene/cloud.ply -o cloud_result");
  ASSERT_EQ(found.code, 0) << found.err;
  const auto objects = nlohmann::json::parse(contents(file("cloud_result") / "objects.json"));
  EXPECT_TRUE(objects.contains("table"));
  EXPECT_GE(objects.at("objects").size(), 3U);
}

TEST_F(SweepCommand, UsesAGivenTablePlaneAndRefusesInvalidOnes) {
  const std::string found = contents(file("scene") / "table_plane.txt");
  const Outcome outcome = run("reconstruct sweep -o given --plane=" + given_plane());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(std::stod(contents(file("given") / "table_plane.txt")), std::stod(found), 1e-9);
  for (const char* bad : {"1,2,3", "0,0,0,1", "a,b,c,d", "nan,0,1,0", "0,0,1,0,7"}) {
    expect_failure(std::string("sweep -o new --plane=") + bad, 2, "--plane");
  }
}

TEST_F(SweepCommand, RefusesOptionsOutOfRangeByName) {
  const std::vector<std::pair<const char*, const char*>> cases = {
      {R"({"tsdf": {"voxel_size": 0}})", "voxel_size"},
      {R"({"tracking": {"min_overlap": 2}})", "min_overlap"},
      {R"({"measurement": {"max_depth": 7}})", "max_depth"},
      {R"({"scene": {"margin": -1}})", "margin"},
      {R"({"surface": {"min_triangles": 0}})", "min_triangles"},
      {R"({"tsdf": {"voxel": 0.01}})", "voxel"}};
  for (const auto& [config, name] : cases) {
    write(file("bad.json"), config);
    expect_failure("sweep -o new --config bad.json", 1, name);
  }
}

TEST_F(SweepCommand, NeverReplacesInputOrFoldersWithOtherFiles) {
  expect_failure("sweep -o sweep", 1, "outside the input");
  fs::create_directories(file("mine"));
  write(file("mine") / "thesis.txt", "text");
  expect_failure("sweep -o mine", 1, "mine");
  EXPECT_EQ(contents(file("mine") / "thesis.txt"), "text");
  expect_failure("nowhere -o new", 1, "nowhere");
}

}  // namespace
}  // namespace symscene::testing
