// symscene reconstruct, run as a process, on complete, broken and empty sequences.
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace symscene::testing {
namespace {

constexpr int frames = 12;

/// A small simulated sweep, one whose camera measures nothing, and the scene of the first.
class ReconstructCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    workspace_ = std::make_unique<Workspace>();
    const std::string camera = R"("tabletop": {"objects": 7}, "camera": {"frames": 12, "arc": 0.09,
      "radius": 0.7, "width": 320, "height": 240, "focal_length": 262})";
    write(*workspace_ / "sweep.json", "{" + camera + "}");
    write(*workspace_ / "dark.json", "{" + camera + R"(, "sensor": {"max_depth": 0.05}})");
    for (const char* name : {"sweep", "dark"}) {
      const std::string line = std::string("simulate --sequence -o ") + name + " --config " + name;
      const Outcome simulated = run(line + ".json");
      ASSERT_EQ(simulated.code, 0) << simulated.err;
    }
    const Outcome reconstructed = run("reconstruct sweep -o scene --json");
    ASSERT_EQ(reconstructed.code, 0) << reconstructed.err;
    report_ = reconstructed.err + reconstructed.out;
  }
  static void TearDownTestSuite() { workspace_.reset(); }

  static Outcome run(const std::string& arguments) { return workspace_->run(arguments); }
  static fs::path file(const std::string& name) { return *workspace_ / name; }
  static const std::string& report() { return report_; }

  /// The table of the scene as the value of --plane.
  static std::string given_plane() {
    const std::string found = contents(file("scene") / "table_plane.txt");
    std::string plane = found.substr(0, found.find_last_not_of('\n') + 1);
    std::replace(plane.begin(), plane.end(), '\n', ',');
    return plane;
  }

  /// A copy of the sweep to modify.
  static fs::path copy_of_sweep(const std::string& name) {
    fs::remove_all(file(name));
    fs::copy(file("sweep"), file(name), fs::copy_options::recursive);
    return file(name);
  }

  static std::string image(int i) {
    const std::string number = std::to_string(i);
    return "depth/" + std::string(6 - number.size(), '0') + number + ".png";
  }

  static nlohmann::json frames_of(const std::string& scene) {
    return nlohmann::json::parse(contents(file(scene) / "scene.json")).at("frames");
  }

  static auto poses_of(const std::string& scene) {
    const std::string text = contents(file(scene) / "poses.txt");
    std::size_t poses = 0, begin = 0;
    while (begin < text.size()) {
      poses += text[begin] != '#' && text[begin] != '\n' ? 1 : 0;
      begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
    }
    return poses;
  }

  /// Checks exit code and message, and that nothing was written.
  static void expect_failure(const std::string& arguments, int code, const std::string& sentence) {
    const Outcome outcome = run("reconstruct " + arguments);
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.err.find("found  "), std::string::npos) << outcome.err;
    for (const auto& entry : fs::directory_iterator(workspace_->folder())) {
      EXPECT_EQ(entry.path().filename().string().find("new"), std::string::npos) << entry.path();
    }
  }

 private:
  static std::unique_ptr<Workspace> workspace_;
  static std::string report_;
};

std::unique_ptr<Workspace> ReconstructCommand::workspace_;
std::string ReconstructCommand::report_;

TEST_F(ReconstructCommand, WritesASceneThatInfoAndSegmentRead) {
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

TEST_F(ReconstructCommand, ReportsItsErrorAgainstThePosesOfTheSequence) {
  const std::size_t at = report().find("absolute error ");
  ASSERT_NE(at, std::string::npos) << report();
  EXPECT_LT(std::stod(report().substr(at + 15)), 5.0) << report();
}

TEST_F(ReconstructCommand, WritesTheSameBytesForAnyNumberOfThreads) {
  for (const char* threads : {"1", "2"}) {
    const std::string scene = std::string("threads") + threads;
    ASSERT_EQ(run("reconstruct sweep -o " + scene + " --threads " + threads).code, 0);
    for (const char* name : {"cloud.ply", "mesh.ply", "occupancy.bt", "occupancy.ot",
                             "table_plane.txt", "poses.txt", "truth.json"}) {
      EXPECT_EQ(contents(file(scene) / name), contents(file("scene") / name)) << name;
    }
  }
}

TEST_F(ReconstructCommand, StitchesFramesThatAreTooFarApartToBeTracked) {
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

TEST_F(ReconstructCommand, UsesThePosesOfTheSequence) {
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

TEST_F(ReconstructCommand, SkipsUnreadableFramesAndNamesThem) {
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

TEST_F(ReconstructCommand, SkipsBlackFramesAndContinuesAfterThem) {
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

TEST_F(ReconstructCommand, ReportsWhyNoFrameCanBeFused) {
  expect_failure("dark -o new", 1, "too little of the image is measured");
  const fs::path sequence = copy_of_sweep("ruin");
  for (int i = 0; i < frames; ++i) fs::resize_file(sequence / image(i), 30);
  expect_failure("ruin -o new", 1, "ruin");
}

TEST_F(ReconstructCommand, WritesNothingIfNoneOfManyFramesCanBeFused) {
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

TEST_F(ReconstructCommand, AcceptsASequenceOfOneFrame) {
  const fs::path sequence = copy_of_sweep("single");
  for (int i = 1; i < frames; ++i) fs::remove(sequence / image(i));
  fs::remove(sequence / "poses.txt");
  const Outcome outcome = run("reconstruct single -o glimpse");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(poses_of("glimpse"), 1U);
  EXPECT_EQ(run("info glimpse").code, 0);
}

TEST_F(ReconstructCommand, SegmentGoesFromOneDepthImageToObjects) {
  const std::string png = (fs::path("sweep") / image(6)).string();
  const Outcome view =
      run("segment " + png + " --intrinsics sweep/intrinsics.txt -o view -v --json");
  ASSERT_EQ(view.code, 0) << view.err;
  EXPECT_NE(view.err.find("unproject"), std::string::npos) << view.err;
  const auto objects = nlohmann::json::parse(contents(file("view") / "objects.json"));
  EXPECT_GE(objects.at("objects").size(), 3U);
  EXPECT_TRUE(objects.contains("table"));
  EXPECT_EQ(poses_of("view"), 1U);
  EXPECT_GT(fs::file_size(file("view") / "surface.ply"), 10000U);
  const Outcome masks = run("masks view " + png +
                            " --depth-scale 1000 -o view_masks --intrinsics sweep/intrinsics.txt");
  EXPECT_EQ(masks.code, 0) << masks.err;
  EXPECT_NE(masks.out.find(" in 1 frame\n"), std::string::npos) << masks.out;
}

TEST_F(ReconstructCommand, MasksRefuseFramesThatSeeThroughTheObjects) {
  const std::string camera = " --intrinsics sweep/intrinsics.txt ";
  const std::string png = (fs::path("sweep") / image(6)).string();
  ASSERT_EQ(run("segment " + png + camera + "-o near").code, 0);
  write(file("far.json"), R"({"tabletop": {"objects": 1}, "camera": {"frames": 1, "radius": 1.6,
      "width": 320, "height": 240, "focal_length": 262}})");
  ASSERT_EQ(run("simulate --sequence -o far --config far.json").code, 0);
  const Outcome masks =
      run("masks near far/" + image(0) + camera + "--depth-scale 1000 -o foreign_masks");
  EXPECT_NE(masks.code, 0);
  EXPECT_NE(masks.err.find("expected the frames of near"), std::string::npos) << masks.err;
  EXPECT_FALSE(fs::exists(file("foreign_masks")));
}

TEST_F(ReconstructCommand, OneFrameGivesTheSameObjectsThroughAScene) {
  const fs::path one = copy_of_sweep("one");
  for (int i = 1; i < frames; ++i) fs::remove(one / image(i));
  fs::remove(one / "poses.txt");
  ASSERT_EQ(run("segment one -o direct").code, 0);
  const Outcome reconstructed = run("reconstruct one -o one_scene");
  ASSERT_EQ(reconstructed.code, 0) << reconstructed.err;
  EXPECT_TRUE(fs::exists(file("one_scene") / "intrinsics.txt"));
  ASSERT_EQ(run("segment one_scene -o through").code, 0);
  const auto count = [](const std::string& result) {
    return nlohmann::json::parse(contents(file(result) / "objects.json")).at("objects").size();
  };
  EXPECT_EQ(count("direct"), count("through"));
  // A plane that nothing is near does not cost the scene.
  const Outcome aside = run("reconstruct one -o one_aside --plane 0,1,0,50");
  ASSERT_EQ(aside.code, 0) << aside.err;
  EXPECT_NE(aside.err.find("--plane: expected a plane with points on it"), std::string::npos)
      << aside.err;
  EXPECT_GT(fs::file_size(file("one_aside") / "cloud.ply"), 10000U);
}

TEST_F(ReconstructCommand, UsesEveryNthFrameAndTellsItsRate) {
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

TEST_F(ReconstructCommand, WritesBesideTheImagesOfItsInput) {
  const fs::path sweep = copy_of_sweep("inner");
  ASSERT_EQ(run("reconstruct inner -o inner/scene --every 4").code, 0);
  ASSERT_EQ(run("reconstruct inner -o ./inner/scene/ --every 4").code, 0);  // replaces it
  EXPECT_TRUE(fs::exists(sweep / "scene/cloud.ply"));
  EXPECT_NE(run("info inner --json").out.find("\"kind\":\"sequence\""), std::string::npos);
  for (const char* output : {"inner", "inner/", "inner/depth", "inner/depth/scene", "inner/color",
                             "inner/poses.txt", "inner/rgb"})
    expect_failure(std::string("inner -o ") + output, 1, "outside the input");
}

TEST_F(ReconstructCommand, AWrongDepthScaleIsNoticed) {
  const std::string png = (fs::path("sweep") / image(6)).string();
  const std::string segment = "segment " + png + " --intrinsics sweep/intrinsics.txt -o scaled";
  for (const char* scale : {"50", "10000"}) {
    const Outcome outcome = run(segment + " --depth-scale " + scale);
    for (const char* part : {"100 % of the depths are outside 0.2 to 6 m", "the median depth is ",
                             "try --depth-scale 1000, which makes it 0."})
      EXPECT_NE(outcome.err.find(part), std::string::npos) << scale << "\n" << outcome.err;
  }
  EXPECT_EQ(run(segment).err.find("--depth-scale"), std::string::npos);
}

TEST_F(ReconstructCommand, ANamedSensorIsNotPrintedAsFound) {
  const std::string png = (fs::path("sweep") / image(6)).string();
  const std::string segment = "segment " + png + " --intrinsics sweep/intrinsics.txt -o seen";
  EXPECT_NE(run(segment + " --sensor tof").out.find("sensor tof: named; "), std::string::npos);
  EXPECT_EQ(run(segment).out.find("named"), std::string::npos);
}

TEST_F(ReconstructCommand, SegmentSaysWhatToDoWithManyFrames) {
  const Outcome outcome = run("segment sweep -o new");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("run symscene reconstruct first"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_F(ReconstructCommand, WithoutATableEverythingIsWrittenAllTheSame) {
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
TEST_F(ReconstructCommand, ABareTableKeepsItsSurface) {
  fs::copy(file("scene"), file("bare"), fs::copy_options::recursive);
  fs::remove(file("bare") / "occupancy.bt");
  write(file("bare") / "cloud.ply",
        "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
        "property float z\nend_header\n");
  const Outcome nothing = run("segment bare -o nothing --page nothing.html");
  ASSERT_EQ(nothing.code, 0) << nothing.err;
  EXPECT_EQ(nothing.err.find("occupancy.bt"), std::string::npos) << nothing.err;
  EXPECT_GT(fs::file_size(file("nothing") / "surface.ply"), 10000U);
  EXPECT_NE(contents(file("nothing.html")).find(R"("surface":{"colors")"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(contents(file("nothing") / "objects.json")).at("objects").size(),
            0U);
}

TEST_F(ReconstructCommand, SegmentFindsTheTableInACloud) {
  const Outcome whole = run("reconstruct sweep -o cloud_scene --no-table");
  ASSERT_EQ(whole.code, 0) << whole.err;
  const Outcome found = run("segment cloud_scene/cloud.ply -o cloud_result");
  ASSERT_EQ(found.code, 0) << found.err;
  const auto objects = nlohmann::json::parse(contents(file("cloud_result") / "objects.json"));
  EXPECT_TRUE(objects.contains("table"));
  EXPECT_GE(objects.at("objects").size(), 3U);
}

TEST_F(ReconstructCommand, UsesAGivenTablePlaneAndRefusesInvalidOnes) {
  const std::string found = contents(file("scene") / "table_plane.txt");
  const Outcome outcome = run("reconstruct sweep -o given --plane=" + given_plane());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(std::stod(contents(file("given") / "table_plane.txt")), std::stod(found), 1e-9);
  for (const char* bad : {"1,2,3", "0,0,0,1", "a,b,c,d", "nan,0,1,0", "0,0,1,0,7"}) {
    expect_failure(std::string("sweep -o new --plane=") + bad, 2, "--plane");
  }
}

TEST_F(ReconstructCommand, RefusesOptionsOutOfRangeByName) {
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

TEST_F(ReconstructCommand, NeverReplacesInputOrFoldersWithOtherFiles) {
  expect_failure("sweep -o sweep", 1, "outside the input");
  fs::create_directories(file("mine"));
  write(file("mine") / "thesis.txt", "text");
  expect_failure("sweep -o mine", 1, "mine");
  EXPECT_EQ(contents(file("mine") / "thesis.txt"), "text");
  expect_failure("nowhere -o new", 1, "nowhere");
}

}  // namespace
}  // namespace symscene::testing
