#include <bit>
#include <csetjmp>
#include <cstring>
#include <new>

#include <fmt/format.h>
#include <png.h>

#include "image_formats.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr const char* image_to_write = "image to write";

/// The destination of libpng. It leaves a failed call by longjmp, so nothing may throw inside.
struct Target {
  std::string bytes;
  bool out_of_memory = false;
  std::jmp_buf jump;
};

extern "C" void symscene_png_write_error(png_structp png, png_const_charp) {
  std::longjmp(static_cast<Target*>(png_get_error_ptr(png))->jump, 1);
}

extern "C" void symscene_png_write_warning(png_structp, png_const_charp) {}

extern "C" void symscene_png_write(png_structp png, png_bytep data, std::size_t size) {
  auto* target = static_cast<Target*>(png_get_io_ptr(png));
  try {
    target->bytes.append(reinterpret_cast<const char*>(data), size);
  } catch (...) {
    target->out_of_memory = true;
  }
  if (target->out_of_memory) png_error(png, "no memory");
}

extern "C" void symscene_png_flush(png_structp) {}

struct Pixels {
  ImageSize size;
  const std::uint8_t* bytes;
  std::size_t row_bytes;
  int bit_depth;
  int color_type;
};

/// Returns whether everything was written.
bool encode(png_structp png, png_infop info, const Pixels& pixels, Target& target) {
  if (setjmp(target.jump) != 0) return false;
  png_set_write_fn(png, &target, symscene_png_write, symscene_png_flush);
  png_set_compression_level(png, 1);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_IHDR(png, info, pixels.size.width, pixels.size.height, pixels.bit_depth,
               pixels.color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
  for (Index row = 0; row < pixels.size.height; ++row) {
    png_write_row(png, pixels.bytes + row * pixels.row_bytes);
  }
  png_write_end(png, nullptr);
  return true;
}

std::string format(const Pixels& pixels) {
  Target target;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &target,
                                            symscene_png_write_error, symscene_png_write_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  const bool done = info != nullptr && encode(png, info, pixels, target);
  png_destroy_write_struct(&png, &info);
  if (!done) throw std::bad_alloc();
  return std::move(target.bytes);
}

void require_values(ImageSize size, std::size_t values) {
  require_image_size(size.width, size.height, image_to_write);
  if (values != size.pixels()) {
    throw InputError(image_to_write, fmt::format("{} pixels", size.pixels()),
                     fmt::format("{}", values));
  }
}

}  // namespace

std::string format_png(const DepthImage& image) {
  require_values(image.size, image.values.size());
  return format({image.size, reinterpret_cast<const std::uint8_t*>(image.values.data()),
                 2 * std::size_t{image.size.width}, 16, PNG_COLOR_TYPE_GRAY});
}

std::string format_png(const ColorImage& image) {
  require_values(image.size, static_cast<std::size_t>(image.pixels.rows()));
  return format(
      {image.size, image.pixels.data(), 3 * std::size_t{image.size.width}, 8, PNG_COLOR_TYPE_RGB});
}

}  // namespace symscene
