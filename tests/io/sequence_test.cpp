#include "symscene/io/sequence.hpp"

#include "io/sequence_support.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;
using namespace io_test;

/// Writes three frames, the last without colour.
void write_small(const fs::path& dir, bool poses) {
  SequenceWriter writer(dir, small_camera());
  for (int i = 0; i < 3; ++i) {
    const Eigen::Isometry3d pose = small_pose(i);
    writer.add(small_frame(i, i < 2), poses ? &pose : nullptr);
  }
  writer.finish();
}

TEST(Sequence, WritingAndReadingGiveTheSame) {
  const TemporaryFolder folder;
  write_small(folder / "sequence", true);
  const auto sequence = open_sequence(folder / "sequence");
  EXPECT_EQ(sequence->layout(), "sequence");
  EXPECT_EQ(sequence->camera().fy, 11.0);
  EXPECT_TRUE(sequence->has_color());
  EXPECT_TRUE(sequence->has_color(0));
  ASSERT_EQ(sequence->size(), 3U);
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    expect_same_frame(sequence->read(at), small_frame(i, i < 2));
    EXPECT_EQ(sequence->time(at), small_frame(i).time);
    ASSERT_TRUE(sequence->pose(at));
    EXPECT_TRUE(sequence->pose(at)->isApprox(small_pose(i), 1e-12));
  }
}

TEST(Sequence, KeepsItsTimesWithoutPoses) {
  const TemporaryFolder folder;
  write_small(folder / "sequence", false);
  const auto sequence = open_sequence(folder / "sequence");
  EXPECT_FALSE(sequence->pose(1));
  EXPECT_EQ(sequence->time(1), small_frame(1).time);
  fs::remove(folder / "sequence/times.txt");
  EXPECT_NEAR(open_sequence(folder / "sequence")->time(1), 1.0 / 30.0, 1e-12);
}

TEST(Sequence, MissingAndOutOfRangeDepthIsWrittenAsZero) {
  const TemporaryFolder folder;
  DepthFrame frame = small_frame(0);
  frame.depth[0] = std::numeric_limits<float>::quiet_NaN();
  frame.depth[1] = -1.0F;
  frame.depth[2] = 70.0F;
  frame.depth[3] = 65.535F;
  frame.depth[4] = 1.23449F;
  SequenceWriter writer(folder / "sequence", small_camera());
  writer.add(frame);
  writer.finish();
  const std::vector<float> depth = open_sequence(folder / "sequence")->read(0).depth;
  EXPECT_EQ((std::vector<float>(depth.begin(), depth.begin() + 6)),
            (std::vector<float>{0.0F, 0.0F, 0.0F, 65.535F, 1.234F, 0.0F}));
}

TEST(Sequence, AppearsCompleteOrNotAtAll) {
  const TemporaryFolder folder;
  {
    SequenceWriter writer(folder / "sequence", small_camera());
    writer.add(small_frame(0));
  }
  EXPECT_TRUE(folder.names().empty());
  write_small(folder / "sequence", true);
  write_small(folder / "sequence", false);
  EXPECT_FALSE(open_sequence(folder / "sequence")->pose(0));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"sequence"});
}

TEST(Sequence, FoldersWithOtherFilesAreNotReplaced) {
  const TemporaryFolder folder;
  write_image(folder / "photos/color/holiday.png", "x");
  EXPECT_THROW(SequenceWriter(folder / "photos", small_camera()), InputError);
  write_small(folder / "sequence", true);
  write_text(folder / "sequence/notes.md", "mine");
  EXPECT_THROW(SequenceWriter(folder / "sequence", small_camera()), InputError);
}

TEST(Sequence, FilesAreWrittenBesideTheImages) {
  const TemporaryFolder folder;
  for (int i = 0; i < 2; ++i) {  // the second replaces the first
    SequenceWriter writer(folder / "sequence", small_camera());
    writer.add(small_frame(0));
    writer.add_file("truth.json", "{}");
    EXPECT_THROW(writer.add_file("../truth.json", "{}"), InputError);
    EXPECT_THROW(writer.add_file("poses.txt", ""), InputError);
    writer.finish();
  }
  EXPECT_EQ(read_text(folder / "sequence/truth.json"), "{}");
}

TEST(Sequence, InconsistentFramesAreNotWritten) {
  const TemporaryFolder folder;
  SequenceWriter writer(folder / "sequence", small_camera());
  const Eigen::Isometry3d pose = small_pose(0);
  EXPECT_THROW(writer.finish(), InputError);
  writer.add(small_frame(1), &pose);
  EXPECT_THROW(writer.add(small_frame(2)), InputError);
  EXPECT_THROW(writer.add(small_frame(0), &pose), InputError);
  DepthFrame frame = small_frame(2);
  frame.depth.pop_back();
  EXPECT_THROW(writer.add(frame, &pose), InputError);
  EXPECT_THROW(SequenceWriter(folder / "other", CameraIntrinsics{}), InputError);
}

TEST(Sequence, GivenIntrinsicsTakePrecedenceOverTheFile) {
  const TemporaryFolder folder;
  write_small(folder / "sequence", true);
  SequenceOptions options;
  options.intrinsics = CameraIntrinsics{0, 0, 20.0, 21.0, 1.0, 2.0};
  options.depth_scale = 2000.0;
  const auto sequence = open_sequence(folder / "sequence", options);
  EXPECT_EQ(sequence->camera().fx, 20.0);
  EXPECT_EQ(sequence->camera().width, frame_size.width);
  EXPECT_NEAR(sequence->read(0).depth[0], 0.25, 1e-6);
}

TEST(Sequence, ErrorsNameTheDamagedFile) {
  const TemporaryFolder folder;
  const fs::path dir = folder / "sequence";
  write_small(dir, true);
  const auto read_all = [&] {
    const auto sequence = open_sequence(dir);
    for (std::size_t i = 0; i < sequence->size(); ++i) sequence->read(i);
  };
  const std::string png = read_text(dir / "depth/000001.png");
  write_text(dir / "depth/000001.png", png.substr(0, png.size() / 2));
  EXPECT_TRUE(refusal(read_all).starts_with((dir / "depth/000001.png").string() +
                                            ": expected a whole PNG image, found "));
  write_text(dir / "depth/000001.png", format_png(random_depth({4, 4}, 1)));
  EXPECT_EQ(refusal(read_all), (dir / "depth/000001.png").string() +
                                   ": expected an image of the camera's size, 8×6, found 4×4");
  write_text(dir / "depth/000001.png", png);
  write_text(dir / "color/000001.png", png.substr(0, 40));
  EXPECT_TRUE(refusal(read_all).starts_with((dir / "color/000001.png").string()));
  write_text(dir / "poses.txt", "0 0 0 0 0 0 0 1\n");
  EXPECT_EQ(refusal(read_all),
            (dir / "poses.txt").string() + ": expected 3 lines, one per depth image, found 1");
  write_text(dir / "intrinsics.txt", "8 6 10 11 3.5");
  EXPECT_EQ(refusal(read_all), (dir / "intrinsics.txt").string() +
                                   ": expected six numbers: width height fx fy cx cy, found the "
                                   "end of the file");
  write_text(dir / "intrinsics.txt", "8 6 0 11 3.5 2.5");
  EXPECT_NE(refusal(read_all).find("focal lengths above 0, found 0"), std::string::npos);
}

TEST(Sequence, OtherFilesAreRefused) {
  const TemporaryFolder folder;
  write_image(folder / "text/notes.txt", "x");
  EXPECT_NE(refusal([&] { open_sequence(folder / "nowhere"); }).find("nothing of that name"),
            std::string::npos);
  EXPECT_NE(refusal([&] { open_sequence(folder / "text"); }).find("another folder"),
            std::string::npos);
  EXPECT_NE(refusal([&] { open_sequence(folder / "text/notes.txt"); }).find("another file"),
            std::string::npos);
  write_image(folder / "empty/intrinsics.txt", "8 6 10 11 3.5 2.5");
  fs::create_directory(folder / "empty/depth");
  EXPECT_NE(refusal([&] { open_sequence(folder / "empty"); }).find("depth images"),
            std::string::npos);
}

TEST(Images, OneDepthImageIsASequenceOfOne) {
  const TemporaryFolder folder;
  write_text(folder / "a.depth.png", small_depth_png(0));
  EXPECT_EQ(refusal([&] { open_sequence(folder / "a.depth.png"); }),
            (folder / "a.depth.png").string() +
                ": expected the camera, which the files of this layout (image) do not give: pass "
                "--intrinsics fx,fy,cx,cy (or a camera.yaml) --depth-scale 1000, found none");
  const auto sequence = open_sequence(folder / "a.depth.png", given_camera(1000.0));
  ASSERT_EQ(sequence->size(), 1U);
  expect_same_frame(sequence->read(0), small_frame(0, false), 1e9);
  EXPECT_FALSE(sequence->has_color());
  write_text(folder / "b.png", format_png(color_ramp(frame_size)));
  EXPECT_NE(refusal([&] {
              open_sequence(folder / "b.png", given_camera(1000.0));
            }).find("expected a PNG of 16-bit grey"),
            std::string::npos);
}

TEST(Images, AFolderOfImagesIsReadInTheOrderOfTheirNumbers) {
  const TemporaryFolder folder;
  for (const int i : {0, 2, 10}) {
    write_image(folder / "images" / ("learn" + std::to_string(i) + ".depth.png"),
                small_depth_png(i));
    write_image(folder / "images" / ("learn" + std::to_string(i) + ".label.png"),
                format_png(color_ramp(frame_size)));
  }
  EXPECT_NE(refusal([&] {
              open_sequence(folder / "images", given_camera());
            }).find("pass --depth-scale 1000"),
            std::string::npos);
  const auto sequence = open_sequence(folder / "images", given_camera(1000.0));
  ASSERT_EQ(sequence->size(), 3U);
  EXPECT_NEAR(sequence->read(1).depth[0], 0.520, 1e-6);
  EXPECT_NEAR(sequence->read(2).depth[0], 0.600, 1e-6);
}

}  // namespace
}  // namespace symscene
