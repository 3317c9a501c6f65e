#include "symscene/io/image.hpp"
#include "io/image_formats.hpp"

#include "io/image_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

constexpr ImageSize small{13, 7};

TEST(Image, WritingAndReadingDepthGiveTheSameBits) {
  for (const ImageSize size : {ImageSize{1, 1}, small, ImageSize{64, 48}}) {
    const DepthImage image = random_depth(size, size.width);
    const DepthImage again = parse_depth_png(format_png(image), "x");
    EXPECT_EQ(again.size, size);
    EXPECT_EQ(again.values, image.values);
  }
}

TEST(Image, WritingAndReadingColoursGiveTheSameBits) {
  const ColorImage image = color_ramp(small);
  const ColorImage again = parse_color_image(format_png(image), "x");
  EXPECT_EQ(again.size, small);
  EXPECT_EQ(again.pixels, image.pixels);
}

TEST(Image, AJpegHasTheColoursUpToRounding) {
  const ColorImage image = color_ramp({40, 24});
  for (const bool progressive : {false, true}) {
    const std::string bytes = make_jpeg(image, progressive);
    const ColorImage again = parse_color_image(bytes, "x");
    EXPECT_EQ(parse_image_size(bytes, "x"), image.size);
    ASSERT_EQ(again.size, image.size);
    EXPECT_LE(difference(again.pixels, image.pixels), 4);
  }
}

TEST(Image, GreyPaletteAlphaAndInterlacedPngsBecomeColours) {
  const std::vector<std::vector<std::uint8_t>> grey(2, {7, 8, 9});
  const ColorImage from_grey =
      parse_color_image(make_png({3, 2}, {8, PNG_COLOR_TYPE_GRAY}, grey), "x");
  EXPECT_EQ(from_grey.pixels.row(1), (Eigen::RowVector3i(8, 8, 8).cast<std::uint8_t>()));
  const std::vector<std::vector<std::uint8_t>> packed(2, {0b01000000});
  const ColorImage from_palette =
      parse_color_image(make_png({3, 2}, {1, PNG_COLOR_TYPE_PALETTE}, packed), "x");
  EXPECT_EQ(from_palette.pixels.row(1), (Eigen::RowVector3i(200, 100, 50).cast<std::uint8_t>()));
  const std::vector<std::vector<std::uint8_t>> alpha(2, {1, 2, 3, 128, 4, 5, 6, 0, 7, 8, 9, 255});
  const ColorImage from_alpha = parse_color_image(
      make_png({3, 2}, {8, PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_ADAM7}, alpha), "x");
  EXPECT_EQ(from_alpha.pixels.row(1), (Eigen::RowVector3i(4, 5, 6).cast<std::uint8_t>()));
  const std::vector<std::vector<std::uint8_t>> wide(2, {1, 2, 3, 4, 5, 6});
  const DepthImage interlaced =
      parse_depth_png(make_png({3, 2}, {16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_ADAM7}, wide), "x");
  EXPECT_EQ(interlaced.values, (std::vector<std::uint16_t>{258, 772, 1286, 258, 772, 1286}));
}

TEST(Image, OtherImagesAreRefusedAsDepthAndDescribed) {
  const auto message = [](const std::string& bytes) {
    return refusal([&] { parse_depth_png(bytes, "0.png"); });
  };
  EXPECT_EQ(message(format_png(color_ramp(small))),
            "0.png: expected a PNG of 16-bit grey, found a PNG of 8-bit colour");
  EXPECT_EQ(message(make_jpeg(color_ramp(small))),
            "0.png: expected a PNG of 16-bit grey, found a JPEG image");
  EXPECT_EQ(message(""), "0.png: expected a PNG image, found other bytes");
  EXPECT_EQ(refusal([] { parse_color_image("GIF89a", "0.jpg"); }),
            "0.jpg: expected a PNG or JPEG image, found other bytes");
}

TEST(Image, HostileSizesAreRefusedBeforeAnythingIsAllocated) {
  const auto refused = [](std::uint32_t width, std::uint32_t height) {
    const std::string head = png_head(width, height, 16, PNG_COLOR_TYPE_GRAY);
    return refusal([&] { parse_depth_png(head, "x"); });
  };
  for (const std::uint32_t side : {0U, 65536U, 0x7fffffffU, 0xffffffffU}) {
    EXPECT_NE(refused(side, side).find("expected an image of 1 to 16777216 pixels"),
              std::string::npos);
    EXPECT_NE(refused(1, side + 16777217U).find("expected"), std::string::npos);
  }
  EXPECT_NE(refused(4096, 4096).find("too few for 4096×4096 pixels"), std::string::npos);
}

TEST(Image, TruncatedImagesAreRefused) {
  EXPECT_EQ(damage(format_png(random_depth(small, 1)),
                   [](std::string_view bytes) { parse_depth_png(bytes, "x"); }),
            0);
  EXPECT_EQ(damage(format_png(color_ramp(small)),
                   [](std::string_view bytes) { parse_color_image(bytes, "x"); }),
            0);
  for (const bool progressive : {false, true}) {
    EXPECT_EQ(damage(make_jpeg(color_ramp(small), progressive),
                     [](std::string_view bytes) { parse_color_image(bytes, "x"); }),
              0);
  }
}

TEST(Image, ImagesWithTheWrongNumberOfValuesAreNotWritten) {
  EXPECT_THROW(format_png(DepthImage{{2, 2}, {1, 2, 3}}), InputError);
  EXPECT_THROW(format_png(ColorImage{{0, 0}, {}}), InputError);
}

}  // namespace
}  // namespace symscene
