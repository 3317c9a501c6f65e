#include <fmt/format.h>

#include "io/sequence_support.hpp"
#include "symscene/io/trajectory.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;
using namespace io_test;

std::string color_png() { return format_png(color_ramp(frame_size)); }
std::string other_size_png() { return format_png(color_ramp({16, 12})); }

std::string matrix_text(const Eigen::Isometry3d& pose) {
  std::string text;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      text += fmt::format("{:.8e} ", pose.matrix()(row, column));
    }
    text += "\n";
  }
  return text;
}

class Tum : public ::testing::Test {
 protected:
  Tum() {
    std::string depth = "# depth maps\n";
    for (int i = 0; i < 3; ++i) {
      const std::string file = fmt::format("depth/{:.6f}.png", small_frame(i).time);
      write_image(dir / file, small_depth_png(i, 5000.0F));
      depth += fmt::format("{:.6f} {}\n", small_frame(i).time, file);
    }
    write_text(dir / "depth.txt", depth);
    write_image(dir / "rgb/a.png", color_png());
    write_text(dir / "rgb.txt", "# color images\n100.015 rgb/a.png\n100.061 rgb/a.png\n");
    write_text(dir / "groundtruth.txt",
               "99.98 0 0 0 0 0 0 1\n100.02 4 0 0 0 0 0 1\n"
               "100.06 8 0 0 0 0 0 1\n100.9 9 0 0 0 0 0 1\n");
  }

  const TemporaryFolder folder_;
  const fs::path dir = folder_ / "tum";
};

TEST_F(Tum, IsReadWithItsOwnDepthScale) {
  const auto sequence = open_sequence(dir, given_camera());
  EXPECT_EQ(sequence->layout(), "TUM RGB-D");
  ASSERT_EQ(sequence->size(), 3U);
  EXPECT_EQ(sequence->camera().width, frame_size.width);
  expect_same_frame(sequence->read(0), small_frame(0));
  expect_same_frame(sequence->read(1), small_frame(1, false));
}

TEST_F(Tum, UsesTheNearestColourAndInterpolatesPoses) {
  const auto sequence = open_sequence(dir, given_camera());
  EXPECT_NE(sequence->read(0).colors.rows(), 0);  // 15 ms off
  EXPECT_EQ(sequence->read(1).colors.rows(), 0);  // 21 ms off
  EXPECT_NE(sequence->read(2).colors.rows(), 0);  // 19 ms off
  ASSERT_TRUE(sequence->pose(0) && sequence->pose(1));
  EXPECT_NEAR(sequence->pose(0)->translation().x(), 2.0, 1e-9);
  EXPECT_NEAR(sequence->pose(1)->translation().x(), 6.0, 1e-9);
  EXPECT_FALSE(sequence->pose(2));  // in a gap of 0.84 s
}

TEST_F(Tum, IsRefusedWithoutIntrinsics) {
  EXPECT_EQ(refusal([&] { open_sequence(dir); }),
            dir.string() +
                ": expected the camera, which the files of this layout (TUM RGB-D) do "
                "not give: pass --intrinsics fx,fy,cx,cy (or a camera.yaml), found none");
}

TEST_F(Tum, ListsThatLeaveTheFolderAreRefused) {
  for (const char* path : {"../secret.png", "/etc/passwd", "depth/../../x.png"}) {
    write_text(dir / "depth.txt", fmt::format("1.0 {}\n", path));
    EXPECT_NE(refusal([&] { open_sequence(dir, given_camera()); }).find("depth.txt: line 1"),
              std::string::npos);
  }
  write_text(dir / "depth.txt", "yesterday depth/1.png\n");
  EXPECT_NE(
      refusal([&] { open_sequence(dir, given_camera()); }).find("a time, found \"yesterday\""),
      std::string::npos);
  write_text(dir / "depth.txt", "1.0 depth/missing.png\n");
  EXPECT_NE(refusal([&] { open_sequence(dir, given_camera()); }).find("missing.png"),
            std::string::npos);
}

TEST_F(Tum, ColourOfAnotherSizeIsLeftOutWithOneWarning) {
  write_image(dir / "rgb/a.png", other_size_png());
  const auto sequence = open_sequence(dir, given_camera());
  EXPECT_FALSE(sequence->has_color());
  expect_same_frame(sequence->read(0), small_frame(0, false));
  ASSERT_EQ(sequence->warnings().size(), 1U);
  EXPECT_NE(sequence->warnings()[0].find("16×12 are not registered to depth images of 8×6"),
            std::string::npos);
}

TEST_F(Tum, AssociationsReplaceLists) {
  fs::remove(dir / "depth.txt");
  write_text(dir / "associations.txt",
             "100.0 rgb/a.png 100.0 depth/100.000000.png\n"
             "100.04 depth/100.040000.png 100.06 rgb/a.png\n");
  const auto sequence = open_sequence(dir, given_camera());
  ASSERT_EQ(sequence->size(), 2U);
  expect_same_frame(sequence->read(0), small_frame(0));
  expect_same_frame(sequence->read(1), small_frame(1));
}

TEST(IclNuim, IsMirroredToAWorldWithTheCamerasYDown) {
  const TemporaryFolder folder;
  const fs::path dir = folder / "icl";
  for (const int i : {0, 1, 2}) {
    write_image(dir / fmt::format("depth/{}.png", i), small_depth_png(i, 5000.0F));
    write_image(dir / fmt::format("rgb/{}.png", i), color_png());
  }
  const double angle = 0.3;
  const Eigen::Isometry3d y_up(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()));
  const Eigen::Quaterniond q(y_up.linear());
  write_text(dir / "living.gt.freiburg",
             fmt::format("1 0 0 0 0 0 0 1\n2 1 2 3 {} 0 0 {}\n", q.x(), q.w()));
  SequenceOptions options = given_camera();
  options.intrinsics->fy = -11.0;
  const auto sequence = open_sequence(dir, options);
  EXPECT_EQ(sequence->layout(), "ICL-NUIM");
  EXPECT_EQ(sequence->camera().fy, 11.0);
  EXPECT_FALSE(sequence->pose(0));
  expect_same_frame(sequence->read(2), small_frame(2), 1e9);
  EXPECT_NEAR(sequence->time(2), 2.0 / 30.0, 1e-9);
  // A point seen 1 m ahead and 0.2 m up is where the y-up pose puts it, mirrored.
  const Eigen::Vector3d world =
      Eigen::Translation3d(1, 2, 3) * (y_up * Eigen::Vector3d(0.0, 0.2, 1.0));
  EXPECT_TRUE((*sequence->pose(2) * Eigen::Vector3d(0.0, -0.2, 1.0))
                  .isApprox(Eigen::Vector3d(world.x(), -world.y(), world.z())));
  EXPECT_NE(refusal([&] { open_sequence(dir)->read(0); }).find("the camera's size, 640×480"),
            std::string::npos);
}

class SevenScenes : public ::testing::Test {
 protected:
  SevenScenes() {
    DepthImage wide{{640, 480}, std::vector<std::uint16_t>(640 * 480, 1500)};
    wide.values[7] = 65535;
    wide.values[8] = 0;
    const ColorImage color{wide.size, Colors::Constant(640 * 480, 3, 9)};
    for (int i = 0; i < 2; ++i) {
      const std::string stem = fmt::format("frame-{:06}", i);
      write_image(dir / (stem + ".depth.png"), format_png(wide));
      write_image(dir / (stem + ".color.png"), format_png(color));
      write_text(dir / (stem + ".pose.txt"), matrix_text(small_pose(i)));
    }
  }
  const TemporaryFolder folder_;
  const fs::path dir = folder_ / "seq-01";
};

TEST_F(SevenScenes, IsReadWithTheCameraThatItDocuments) {
  const auto sequence = open_sequence(dir);
  const std::vector<std::string>& messages = sequence->warnings();
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_NE(messages[0].find("585,585,320,240"), std::string::npos);
  EXPECT_NE(messages[1].find("did not register"), std::string::npos);
  EXPECT_EQ(sequence->layout(), "7-Scenes");
  ASSERT_EQ(sequence->size(), 2U);
  EXPECT_EQ(sequence->camera().fx, 585.0);
  const DepthFrame frame = sequence->read(1);
  EXPECT_NEAR(frame.time, 1.0 / 30.0, 1e-12);
  EXPECT_EQ(frame.depth[6], 1.5F);
  EXPECT_EQ(frame.depth[7], 0.0F);
  EXPECT_EQ(frame.depth[8], 0.0F);
  EXPECT_EQ(frame.colors(0, 0), 9);
  ASSERT_TRUE(sequence->pose(1));
  EXPECT_TRUE(sequence->pose(1)->isApprox(small_pose(1), 1e-7));
}

TEST_F(SevenScenes, PosesMayBeMissingOrLost) {
  fs::remove(dir / "frame-000000.pose.txt");
  write_text(dir / "frame-000001.pose.txt",
             "nan nan nan nan nan nan nan nan nan nan nan nan 0 0 0 1");
  const auto sequence = open_sequence(dir);
  EXPECT_FALSE(sequence->pose(0) || sequence->pose(1));
  write_text(dir / "frame-000001.pose.txt", "1 2 3");
  EXPECT_NE(refusal([&] { open_sequence(dir); }).find("frame-000001.pose.txt"), std::string::npos);
}

class Redwood : public ::testing::Test {
 protected:
  Redwood() {
    std::string log;
    for (int i = 0; i < 3; ++i) {
      write_image(dir / fmt::format("depth/{:05}.png", i), small_depth_png(i));
      write_image(dir / fmt::format("image/{:05}.jpg", i), make_jpeg(color_ramp(frame_size)));
      log += fmt::format("{} {} {}\n", i, i, i + 1) + matrix_text(small_pose(i));
    }
    write_text(dir / "trajectory.log", log);
    write_text(
        dir / "camera_primesense.json",
        R"({"width": 8, "height": 6, "intrinsic_matrix": [10, 0, 0, 0, 11, 0, 3.5, 2.5, 1]})");
  }
  const TemporaryFolder folder_;
  const fs::path dir = folder_ / "redwood";
};

TEST_F(Redwood, IsReadWithItsCameraAndTrajectory) {
  const auto sequence = open_sequence(dir);
  EXPECT_EQ(sequence->layout(), "Redwood");
  ASSERT_EQ(sequence->size(), 3U);
  EXPECT_EQ(sequence->camera().fx, 10.0);
  EXPECT_EQ(sequence->camera().fy, 11.0);
  EXPECT_EQ(sequence->camera().cx, 3.5);
  const DepthFrame frame = sequence->read(2);
  EXPECT_NEAR(frame.depth[0], 0.52, 1e-6);
  EXPECT_LE(difference(frame.colors, color_ramp(frame_size).pixels), 4);
  ASSERT_TRUE(sequence->pose(2));
  EXPECT_TRUE(sequence->pose(2)->isApprox(small_pose(2), 1e-7));
}

TEST_F(Redwood, PosesBelongToTheFramesOfTheirNumbers) {
  write_text(dir / "trajectory.log", "2 2 3\n" + matrix_text(small_pose(5)));
  const auto sequence = open_sequence(dir);
  EXPECT_FALSE(sequence->pose(0) || sequence->pose(1));
  EXPECT_TRUE(sequence->pose(2)->isApprox(small_pose(5), 1e-7));
  write_text(dir / "trajectory.log", "3 3 4\n" + matrix_text(small_pose(5)));
  EXPECT_NE(refusal([&] { open_sequence(dir); }).find("the number of one of 3 frames, found 3"),
            std::string::npos);
}

TEST_F(Redwood, ImagesWithTimesInTheirNamesArePairedByTime) {
  fs::remove_all(dir / "depth");
  fs::rename(dir / "image", dir / "rgb");
  fs::remove(dir / "trajectory.log");
  write_image(dir / "depth/0000001-000000033369.png", small_depth_png(0));
  write_image(dir / "depth/0000002-000000066738.png", small_depth_png(1));
  write_image(dir / "rgb/0000001-000000080000.jpg", make_jpeg(color_ramp(frame_size)));
  const auto sequence = open_sequence(dir);
  ASSERT_EQ(sequence->size(), 2U);
  EXPECT_NEAR(sequence->time(1), 0.066738, 1e-12);
  EXPECT_EQ(sequence->read(0).colors.rows(), 0);
  EXPECT_NE(sequence->read(1).colors.rows(), 0);
}

TEST_F(Redwood, IsRefusedWithoutACamera) {
  fs::remove(dir / "camera_primesense.json");
  EXPECT_NE(refusal([&] { open_sequence(dir); }).find("pass --intrinsics fx,fy,cx,cy"),
            std::string::npos);
  EXPECT_EQ(open_sequence(dir, given_camera())->camera().width, 8U);
  write_text(dir / "camera.json", R"({"width": 8, "height": 6, "intrinsic_matrix": [1, 2]})");
  EXPECT_NE(refusal([&] { open_sequence(dir); }).find("camera.json: intrinsic_matrix: expected"),
            std::string::npos);
}

TEST(Layouts, ADepthFolderWithoutACameraIsRefusedWithTheMissingOptions) {
  const TemporaryFolder folder;
  write_image(folder / "bare/depth/000000.png", small_depth_png(0));
  EXPECT_NE(refusal([&] { open_sequence(folder / "bare"); })
                .find("(sequence) do not give: pass --intrinsics fx,fy,cx,cy (or a camera.yaml), "
                      "found none"),
            std::string::npos);
  expect_same_frame(open_sequence(folder / "bare", given_camera())->read(0), small_frame(0, false),
                    1e9);
}

TEST(Layouts, InvalidCamerasAndScalesAreRefused) {
  const TemporaryFolder folder;
  write_image(folder / "bare/depth/000000.png", small_depth_png(0));
  for (const double scale : {0.0, -1.0, 1e-60, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(open_sequence(folder / "bare", given_camera(scale)), InputError) << scale;
  }
  SequenceOptions options = given_camera();
  options.intrinsics->fx = -1.0;
  EXPECT_THROW(open_sequence(folder / "bare", options), InputError);
  options.intrinsics = CameraIntrinsics{9, 6, 10.0, 11.0, 3.5, 2.5};
  EXPECT_THROW(open_sequence(folder / "bare", options)->read(0), InputError);
  // That of an image of twice the size.
  options.intrinsics = CameraIntrinsics{0, 0, 20.0, 22.0, 7.5, 5.5};
  EXPECT_NE(refusal([&] {
              open_sequence(folder / "bare", options);
            }).find("expected a principal point in the image of 8×6 pixels, found 7.5,5.5"),
            std::string::npos);
}

TEST(Layouts, TheTumSampleIsReadCompletely) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << "skipped: no data";
  SequenceOptions options;
  options.intrinsics = CameraIntrinsics{0, 0, 517.3, 516.5, 318.6, 255.3};
  const auto sequence = open_sequence(*data / "tum_fr1_xyz", options);
  ASSERT_EQ(sequence->size(), 300U);
  EXPECT_EQ(sequence->camera().width, 640U);
  std::size_t colored = 0;
  std::size_t posed = 0;
  for (std::size_t i = 0; i < sequence->size(); ++i) {
    const DepthFrame frame = sequence->read(i);
    colored += frame.colors.rows() != 0 ? 1 : 0;
    posed += sequence->pose(i) ? 1 : 0;
    const auto measured = std::count_if(frame.depth.begin(), frame.depth.end(),
                                        [](float depth) { return depth > 0.3F && depth < 10.0F; });
    EXPECT_GT(measured, 100000) << i;
  }
  EXPECT_GE(colored, 30U);
  EXPECT_EQ(posed, 297U);  // motion capture lost the camera for more than 0.1 s
}

TEST(Layouts, TheSegmentationSampleIsAFolderOfImages) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << "skipped: no data";
  SequenceOptions options;
  options.intrinsics = CameraIntrinsics{0, 0, 525.0, 525.0, 319.5, 239.5};
  options.depth_scale = 1000.0;
  EXPECT_EQ(open_sequence(*data / "osd_learn", options)->size(), 45U);
  const auto one = open_sequence(*data / "osd_learn/learn7.depth.png", options);
  EXPECT_EQ(one->read(0).depth.size(), 640U * 480U);
}

}  // namespace
}  // namespace symscene
