#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// The width and height of an image. [px]
struct ImageSize {
  Index width = 0;
  Index height = 0;

  std::size_t pixels() const { return std::size_t{width} * height; }
  bool operator==(const ImageSize&) const = default;
};

/// An image of 16-bit values, rows from the top. Their unit is up to the caller.
struct DepthImage {
  ImageSize size;
  std::vector<std::uint16_t> values;
};

/// A colour image, rows from the top.
struct ColorImage {
  ImageSize size;
  Colors pixels;  ///< width · height × 3
};

/// Parses a PNG of 16-bit grey. `name` is the name of the file in messages.
/// Throws InputError if the bytes are another image, truncated or corrupt, or the image has more
/// than 2^24 pixels.
DepthImage parse_depth_png(std::string_view bytes, const std::string& name);
DepthImage read_depth_png(const std::filesystem::path& path);

/// Parses a PNG of any kind (transparency is dropped) or a grey or colour JPEG, recognised by the
/// first bytes. Throws InputError as parse_depth_png() does.
ColorImage parse_color_image(std::string_view bytes, const std::string& name);
ColorImage read_color_image(const std::filesystem::path& path);

/// Whether the file begins as a PNG of 16-bit grey.
bool is_depth_png(const std::filesystem::path& path);

/// The bytes of a PNG, compressed for speed rather than size.
/// Throws InputError if the number of values is not that of the pixels, or there are too many.
std::string format_png(const DepthImage& image);
std::string format_png(const ColorImage& image);

}  // namespace symscene
