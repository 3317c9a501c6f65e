#include "symscene/io/camera_file.hpp"

#include "io/io_support.hpp"
#include "io/sequence_support.hpp"
#include "symscene/core/frame_rectifier.hpp"

namespace symscene {
namespace {

using namespace io_test;

CameraModel full_model() {
  CameraModel camera;
  camera.intrinsics = small_camera();
  camera.distortion = {-0.1, 0.02, 1e-5, -0.002, 0.3};
  camera.depth_correction =
      DepthCorrection{8, 6, 2, 1, 2, 0.5, 0.25, {1.01F, 0.99F, 1.02F, 0.5F}, {1, 1, 0, 1}};
  camera.color = ColorCamera{{16, 12, 20.0, 21.0, 7.0, 5.0}, {0.1, 0, 0, 0, 0}, small_pose(2)};
  return camera;
}

#ifdef SYMSCENE_HAS_ROBOTS

TEST(CameraFile, WritingAndReadingGiveTheSameBits) {
  const CameraModel camera = full_model();
  const std::string text = format_camera_model(camera);
  const CameraModel again = parse_camera_model(text, "x.yaml");
  EXPECT_EQ(again.intrinsics.cx, camera.intrinsics.cx);
  EXPECT_EQ(again.color->intrinsics.fy, camera.color->intrinsics.fy);
  EXPECT_EQ(again.distortion.p1, camera.distortion.p1);
  EXPECT_EQ(again.depth_correction->factors, camera.depth_correction->factors);
  EXPECT_EQ(again.depth_correction->measured, camera.depth_correction->measured);
  EXPECT_TRUE(again.color->T_depth_color.isApprox(camera.color->T_depth_color, 1e-12));
}

TEST(CameraFile, CameraInfoOfRosIsReadAsFileAndAsMessage) {
  const CameraModel file = parse_camera_model(
      "image_width: 640\nimage_height: 480\ncamera_name: depth\n"
      "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [570, 0, 320, 0, 571, 240, 0, 0, 1]\n"
      "distortion_model: plumb_bob\n"
      "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [-0.1, 0.2, 0.001, 0.002, -0.3]\n",
      "depth.yaml");
  EXPECT_EQ(file.intrinsics.fy, 571.0);
  EXPECT_EQ(file.intrinsics.cy, 240.0);
  EXPECT_EQ(file.distortion.p2, 0.002);
  EXPECT_EQ(file.distortion.k3, -0.3);
  for (const char* names : {"KD", "kd"}) {
    const std::string text = std::string("width: 640\nheight: 480\n") + names[0] +
                             ": [570, 0, 320, 0, 571, 240, 0, 0, 1]\n" + names[1] +
                             ": [0.1, 0, 0, 0, 0, 0, 0, 0]\n";
    EXPECT_EQ(parse_camera_model(text, "info.yaml").distortion.k1, 0.1) << text;
  }
}

TEST(CameraFile, OtherModelsOfDistortionAndOtherTextsAreRefused) {
  const std::string camera = "width: 640\nheight: 480\nk: [570, 0, 320, 0, 571, 240, 0, 0, 1]\n";
  for (const std::string& text :
       {camera + "d: [0, 0, 0, 0]\ndistortion_model: equidistant\n",
        camera + "d: [0, 0, 0, 0, 0, 0.5]\n", std::string("[]"), std::string("version: 1"),
        std::string("version: 1\nwidth: 0\nheight: 4\nintrinsics: {fx: 1, fy: 1, cx: 1, cy: 1}\n"),
        std::string("version: 1\nwidth: 4\nheight: 4\nintrinsics: {fx: 1, fy: 1, cx: 1, cy: 1}\n"
                    "depth_correction: {columns: 5, rows: 1, first_range_m: 1, range_step_m: 1, "
                    "factors: [[1, 1, 1, 1, 1]], measured: [[1, 1, 1, 1, 1]]}\n")}) {
    EXPECT_THROW(parse_camera_model(text, "x.yaml"), InputError) << text;
  }
}

TEST(CameraFile, DamagedFilesAreReadOrRefused) {
  damage(format_camera_model(full_model()),
         [](std::string_view bytes) { parse_camera_model(bytes, "x.yaml"); });
}

#endif

TEST(OpenSequence, FramesOfACalibratedCameraAreRectified) {
  const TemporaryFolder folder;
  SequenceWriter writer(folder / "sweep", small_camera());
  writer.add(small_frame(0));
  writer.add(small_frame(1));
  writer.finish();
  CameraModel camera = full_model();
  camera.color.reset();
  SequenceOptions options;
  options.camera = camera;
  const auto sequence = open_sequence(folder / "sweep", options);
  EXPECT_EQ(sequence->camera().fx, camera.intrinsics.fx);
  expect_same_frame(sequence->read(1),
                    FrameRectifier(camera).rectified(open_sequence(folder / "sweep")->read(1)));
}

TEST(OpenSequence, ColoursOfAColourCameraOfItsOwnAreRegistered) {
  const TemporaryFolder folder;
  write_image(folder / "sweep/depth/000000.png", small_depth_png(0));
  write_image(folder / "sweep/color/000000.png", format_png(color_ramp({16, 12})));
  write_text(folder / "sweep/intrinsics.txt", "8 6 10 11 3.5 2.5\n");
  EXPECT_FALSE(open_sequence(folder / "sweep")->has_color());
  SequenceOptions options;
  options.camera = CameraModel{small_camera(), {}, {}, full_model().color};
  const auto sequence = open_sequence(folder / "sweep", options);
  ASSERT_TRUE(sequence->has_color());
  EXPECT_EQ(sequence->read(0).colors.rows(), 48);
  options.camera->color->intrinsics.width = 17;
  EXPECT_EQ(open_sequence(folder / "sweep", options)->warnings().size(), 1U);
}

TEST(OpenSequence, RefusesACalibrationForImagesOfAnotherSize) {
  const TemporaryFolder folder;
  SequenceWriter writer(folder / "sweep", small_camera());
  writer.add(small_frame(0));
  writer.finish();
  SequenceOptions options;
  options.camera = CameraModel{{16, 12, 20.0, 22.0, 7.0, 5.0}, {}, {}, {}};
  EXPECT_THROW(open_sequence(folder / "sweep", options)->read(0), InputError);
}

}  // namespace
}  // namespace symscene
