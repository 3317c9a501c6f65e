#include "symscene/io/intrinsics.hpp"
#include "io/camera_formats.hpp"

#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

TEST(Intrinsics, WritingAndReadingGiveTheSameBits) {
  const CameraIntrinsics camera{640, 480, 517.3, 516.5, 318.6, 255.3};
  const CameraIntrinsics again = parse_intrinsics(format_intrinsics(camera), "x");
  EXPECT_EQ(again.width, 640U);
  EXPECT_EQ(again.height, 480U);
  EXPECT_EQ(again.fx, camera.fx);
  EXPECT_EQ(again.fy, camera.fy);
  EXPECT_EQ(again.cx, camera.cx);
  EXPECT_EQ(again.cy, camera.cy);
}

TEST(Intrinsics, AnythingButACameraIsRefused) {
  for (const char* text :
       {"", "640 480 1 1 1", "640 480 1 1 1 1 1", "0 480 1 1 1 1", "640.5 480 1 1 1 1",
        "640 480 0 1 1 1", "640 480 1 -1 1 1", "640 480 nan 1 1 1", "640 480 1 1 inf 1",
        "-640 480 1 1 1 1", "65536 65536 1 1 1 1", "1e300 480 1 1 1 1", "a b c d e f"}) {
    EXPECT_THROW(parse_intrinsics(text, "x"), InputError) << text;
  }
}

TEST(Intrinsics, OfOpen3dAreReadByColumns) {
  const CameraIntrinsics camera = parse_intrinsics_json(
      R"({"width": 640, "height": 480, "intrinsic_matrix": [525, 0, 0, 0, 526, 0, 319.5, 239.5, 1]})",
      "x");
  EXPECT_EQ(camera.width, 640U);
  EXPECT_EQ(camera.fx, 525.0);
  EXPECT_EQ(camera.fy, 526.0);
  EXPECT_EQ(camera.cx, 319.5);
  EXPECT_EQ(camera.cy, 239.5);
  for (const char* text :
       {"", "[]", "{}", R"({"width": 640, "height": 480})",
        R"({"width": "a", "height": 1, "intrinsic_matrix": [1,0,0,0,1,0,1,1,1]})",
        R"({"width": 4, "height": 1, "intrinsic_matrix": [0,0,0,0,1,0,1,1,1]})"}) {
    EXPECT_THROW(parse_intrinsics_json(text, "x"), InputError) << text;
  }
}

TEST(Intrinsics, DamagedFilesAreReadOrRefused) {
  damage("640 480 517.3 516.5 318.6 255.3\n",
         [](std::string_view bytes) { parse_intrinsics(bytes, "x"); });
}

}  // namespace
}  // namespace symscene
