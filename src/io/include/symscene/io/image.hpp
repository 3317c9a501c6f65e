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

/// An image of 16-bit numbers, rows from the top; what they count is the caller's to know.
struct DepthImage {
  ImageSize size;
  std::vector<std::uint16_t> values;
};

/// A colour image, rows from the top.
struct ColorImage {
  ImageSize size;
  Colors pixels;  ///< width · height × 3
};

/// The most pixels an image may have: 4096 × 4096.
constexpr std::size_t largest_image = std::size_t{1} << 24;

/// The numbers of a PNG of 16-bit grey. `name` stands for the file in messages.
/// Throws InputError if the bytes are another image, are cut off or corrupt, or are too many
/// pixels.
DepthImage parse_depth_png(std::string_view bytes, const std::string& name);
DepthImage read_depth_png(const std::filesystem::path& path);

/// The colours of a PNG of any kind (transparency is dropped) or a grey or colour JPEG, told apart
/// by the first bytes. Throws InputError as parse_depth_png() does.
ColorImage parse_color_image(std::string_view bytes, const std::string& name);
ColorImage read_color_image(const std::filesystem::path& path);

/// The size that the head of a PNG or JPEG file says. Throws InputError if it is neither.
ImageSize parse_image_size(std::string_view bytes, const std::string& name);
ImageSize read_image_size(const std::filesystem::path& path);

/// Whether the file's head is that of a PNG of 16-bit grey.
bool is_depth_png(const std::filesystem::path& path);

/// The bytes of a PNG, packed for speed rather than size.
/// Throws InputError if there are not as many values as pixels, or too many.
std::string format_png(const DepthImage& image);
std::string format_png(const ColorImage& image);

}  // namespace symscene
