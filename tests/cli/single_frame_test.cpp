// What the commands make of one depth image.
#include "cli/small_sweep.hpp"

namespace symscene::testing {
namespace {

TEST_F(SweepCommand, AcceptsASequenceOfOneFrame) {
  copy_of_first_frame("single");
  const Outcome outcome = run("reconstruct single -o glimpse");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(poses_of("glimpse"), 1U);
  EXPECT_EQ(run("info glimpse").code, 0);
}

TEST_F(SweepCommand, SegmentGoesFromOneDepthImageToObjects) {
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

TEST_F(SweepCommand, ViewPlaysTheDepthImagesOfItsSequence) {
  const std::string camera = " --intrinsics sweep/intrinsics.txt --depth-scale 1000 ";
  const std::string png = (fs::path("sweep") / image(6)).string();
  ASSERT_EQ(run("segment " + png + camera + "-o seen").code, 0);
  const Outcome shown = run("view seen --sequence " + png + camera + "-o played.html");
  ASSERT_EQ(shown.code, 0) << shown.err;
  EXPECT_NE(contents(file("played.html")).find("\"sweep\":[{\"camera\":"), std::string::npos);
}

TEST_F(SweepCommand, MasksRefuseFramesThatSeeThroughTheObjects) {
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

TEST_F(SweepCommand, OneFrameGivesTheSameObjectsThroughAScene) {
  copy_of_first_frame("one");
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

TEST_F(SweepCommand, AWrongDepthScaleIsNoticed) {
  const std::string png = (fs::path("sweep") / image(6)).string();
  const std::string segment = "segment " + png + " --intrinsics sweep/intrinsics.txt -o scaled";
  for (const char* scale : {"50", "10000"}) {
    const Outcome outcome = run(segment + " --depth-scale " + scale);
    for (const char* part : {"100 % of the depths are outside 0.2 to 6 m", "the median depth is ",
                             "try --depth-scale 1000, which makes it 0."})
      EXPECT_NE(outcome.err.find(part), std::string::npos) << scale << "\n" << outcome.err;
  }
  // The depths are used then, but the table is 25 times as large.
  const Outcome five_times = run(segment + " --depth-scale 200");
  EXPECT_NE(five_times.err.find("unless it is a floor, try --depth-scale 1000, which makes it "),
            std::string::npos)
      << five_times.err;
  EXPECT_EQ(run(segment).err.find("--depth-scale"), std::string::npos);
}

TEST_F(SweepCommand, ANamedSensorIsNotPrintedAsFound) {
  const std::string png = (fs::path("sweep") / image(6)).string();
  const std::string segment = "segment " + png + " --intrinsics sweep/intrinsics.txt -o seen";
  EXPECT_NE(run(segment + " --sensor tof").out.find("sensor tof: named; "), std::string::npos);
  EXPECT_EQ(run(segment).out.find("named"), std::string::npos);
}

TEST_F(SweepCommand, MasksBesideAFrameAreNotPartOfWhatMadeTheResult) {
  copy_of_first_frame("masked");
  const auto files = [](const std::string& result) {
    EXPECT_EQ(run("segment masked -o " + result).code, 0);
    const auto objects = nlohmann::json::parse(contents(file(result) / "objects.json"));
    return objects.at("made_by").at("files");
  };
  const auto before = files("without_masks");
  ASSERT_EQ(run("masks without_masks masked -o masked/masks").code, 0);
  EXPECT_EQ(files("with_masks"), before);
}

}  // namespace
}  // namespace symscene::testing
