#pragma once

#include <string>
#include <string_view>

#include "symscene/io/image.hpp"

namespace symscene {

/// The most pixels an image may have: 4096 × 4096.
constexpr std::size_t largest_image = std::size_t{1} << 24;

inline bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }
inline bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"); }

/// Throws InputError unless an image has between 1 and largest_image pixels.
void require_image_size(std::uint64_t width, std::uint64_t height, const std::string& name);

ColorImage parse_color_png(std::string_view bytes, const std::string& name);
ColorImage parse_jpeg(std::string_view bytes, const std::string& name);
ImageSize parse_jpeg_size(std::string_view bytes, const std::string& name);

/// The size in the header of a PNG or JPEG file. Throws InputError if it is neither.
ImageSize parse_image_size(std::string_view bytes, const std::string& name);
ImageSize read_image_size(const std::filesystem::path& path);

/// The header of a PNG.
struct PngHeader {
  ImageSize size;
  int bit_depth = 0;
  int color_type = 0;  ///< 0 grey, 2 colour, 3 palette, 4 grey and alpha, 6 colour and alpha
};
PngHeader parse_png_header(std::string_view bytes, const std::string& name);
/// "a PNG of 8-bit colour"
std::string describe(const PngHeader& header);

}  // namespace symscene
