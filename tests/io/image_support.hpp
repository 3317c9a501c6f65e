#pragma once

#include <cstdio>
#include <random>
#include <string>
#include <vector>

// Needs cstdio before it.
#include <jpeglib.h>
#include <png.h>

#include "io/io_support.hpp"
#include "symscene/io/image.hpp"

namespace symscene::io_test {

/// The bytes of a PNG of any kind, written by libpng.
struct PngKind {
  int bit_depth = 8;
  int color_type = PNG_COLOR_TYPE_RGB;
  int interlace = PNG_INTERLACE_NONE;
};
inline std::string make_png(ImageSize size, const PngKind& kind,
                            const std::vector<std::vector<std::uint8_t>>& rows) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp p, png_bytep data, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(p))
            ->append(reinterpret_cast<const char*>(data), count);
      },
      nullptr);
  png_set_IHDR(png, info, size.width, size.height, kind.bit_depth, kind.color_type, kind.interlace,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  const png_color palette[2] = {{10, 20, 30}, {200, 100, 50}};
  if (kind.color_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
  png_write_info(png, info);
  std::vector<png_bytep> pointers;
  for (const auto& row : rows) pointers.push_back(const_cast<png_bytep>(row.data()));
  png_write_image(png, pointers.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

/// The bytes of a JPEG of the highest quality.
inline std::string make_jpeg(const ColorImage& image, bool progressive = false) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &data, &size);
  info.image_width = image.size.width;
  info.image_height = image.size.height;
  info.input_components = 3;
  info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 100, TRUE);
  info.comp_info[0].h_samp_factor = info.comp_info[0].v_samp_factor = 1;
  if (progressive) jpeg_simple_progression(&info);
  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < info.image_height) {
    auto* row =
        const_cast<JSAMPROW>(image.pixels.data() + 3 * info.next_scanline * image.size.width);
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  jpeg_destroy_compress(&info);
  std::free(data);
  return bytes;
}

/// Random values, and values that change slowly from pixel to pixel.
inline DepthImage random_depth(ImageSize size, unsigned seed) {
  std::mt19937 random(seed);
  DepthImage image{size, {}};
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    image.values.push_back(static_cast<std::uint16_t>(random() % 65536));
  }
  return image;
}
inline ColorImage color_ramp(ImageSize size) {
  ColorImage image{size, Colors(static_cast<Eigen::Index>(size.pixels()), 3)};
  for (Eigen::Index i = 0; i < image.pixels.rows(); ++i) {
    const auto x = static_cast<int>(i) % static_cast<int>(size.width);
    const auto y = static_cast<int>(i) / static_cast<int>(size.width);
    image.pixels.row(i) << static_cast<std::uint8_t>(40 + 3 * x),
        static_cast<std::uint8_t>(200 - 2 * y), static_cast<std::uint8_t>(x + y);
  }
  return image;
}

/// The largest difference of two values of a channel.
inline int difference(const Colors& a, const Colors& b) {
  return (a.cast<int>() - b.cast<int>()).cwiseAbs().maxCoeff();
}

/// The header of a PNG with a correct checksum, and nothing after it.
inline std::string png_head(std::uint32_t width, std::uint32_t height, int bit_depth,
                            int color_type) {
  std::string head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
  for (const std::uint32_t number : {width, height}) {
    for (const int shift : {24, 16, 8, 0}) head += static_cast<char>(number >> shift & 255U);
  }
  head += static_cast<char>(bit_depth);
  head += static_cast<char>(color_type);
  head += std::string(3, '\0');
  std::uint32_t sum = ~0U;  // CRC-32 of the type and the data
  for (const char c : head.substr(12)) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1U) != 0 ? 0xedb88320U : 0U);
  }
  for (const int shift : {24, 16, 8, 0}) head += static_cast<char>(~sum >> shift & 255U);
  return head;
}

}  // namespace symscene::io_test
