#include "symscene/io/image.hpp"

#include <fstream>

#include <fmt/format.h>

#include "image_formats.hpp"
#include "io/atomic_file.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Reads as many bytes of a file as a PNG header has.
std::string read_head(const std::filesystem::path& path) {
  require_regular_file(path);
  std::ifstream stream(path, std::ios::binary);
  std::string head(64, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

[[noreturn]] void refuse_format(std::string_view bytes, const std::string& name) {
  throw InputError(name, "a PNG or JPEG image", bytes.empty() ? "no bytes" : "other bytes");
}

}  // namespace

void require_image_size(std::uint64_t width, std::uint64_t height, const std::string& name) {
  if (width >= 1 && height >= 1 && width <= largest_image && height <= largest_image / width) {
    return;
  }
  throw InputError(name, fmt::format("an image of 1 to {} pixels", largest_image),
                   fmt::format("a size of {}×{}", width, height));
}

DepthImage read_depth_png(const std::filesystem::path& path) {
  return parse_depth_png(read_file(path), path.string());
}

ColorImage parse_color_image(std::string_view bytes, const std::string& name) {
  if (is_png(bytes)) return parse_color_png(bytes, name);
  if (is_jpeg(bytes)) return parse_jpeg(bytes, name);
  refuse_format(bytes, name);
}

ColorImage read_color_image(const std::filesystem::path& path) {
  return parse_color_image(read_file(path), path.string());
}

ImageSize parse_image_size(std::string_view bytes, const std::string& name) {
  if (is_png(bytes)) return parse_png_header(bytes, name).size;
  if (is_jpeg(bytes)) return parse_jpeg_size(bytes, name);
  refuse_format(bytes, name);
}

ImageSize read_image_size(const std::filesystem::path& path) {
  const std::string head = read_head(path);
  return parse_image_size(is_png(head) ? head : read_file(path), path.string());
}

bool is_depth_png(const std::filesystem::path& path) {
  const std::string head = read_head(path);
  if (!is_png(head)) return false;
  try {
    const PngHeader header = parse_png_header(head, path.string());
    return header.bit_depth == 16 && header.color_type == 0;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace symscene
