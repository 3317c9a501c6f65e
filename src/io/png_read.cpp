#include <array>
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

/// Largest compression ratio of deflate; a file cannot contain more pixels than that.
constexpr std::size_t most_inflation = 1032;

constexpr std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char c : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

/// The source of libpng and its error message. It leaves a failed call by
/// longjmp: while one runs, nothing with a destructor may be on the stack above `jump`.
struct Source {
  std::string_view rest;
  std::jmp_buf jump;
  std::array<char, 96> message{};
};

extern "C" void symscene_png_error(png_structp png, png_const_charp message) {
  auto* source = static_cast<Source*>(png_get_error_ptr(png));
  std::strncpy(source->message.data(), message, source->message.size() - 1);
  std::longjmp(source->jump, 1);
}

extern "C" void symscene_png_warning(png_structp, png_const_charp) {}

extern "C" void symscene_png_read(png_structp png, png_bytep data, std::size_t size) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (size > source->rest.size()) png_error(png, "the end of the file");
  std::memcpy(data, source->rest.data(), size);
  source->rest.remove_prefix(size);
}

/// Decodes a PNG with libpng.
class Decoder {
 public:
  Decoder(std::string_view bytes, const std::string& name) : name_(name) {
    source_.rest = bytes;
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, symscene_png_error,
                                  symscene_png_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
  }
  ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  /// Reads up to the pixels; `convert` sets their transformations.
  void begin(void (*convert)(png_structp)) {
    convert_ = convert;
    require(start());
  }
  std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }

  /// Decodes the pixels into rows one after another, and the rest of the file.
  void read(png_bytep pixels, png_uint_32 height) { require(finish(pixels, height)); }

 private:
  bool start() {
    if (setjmp(source_.jump) != 0) return false;
    png_set_read_fn(png_, &source_, symscene_png_read);
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_set_chunk_malloc_max(png_, 1 << 16);
    png_read_info(png_, info_);
    convert_(png_);
    passes_ = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  bool finish(png_bytep pixels, png_uint_32 height) {
    if (setjmp(source_.jump) != 0) return false;
    const std::size_t stride = row_bytes();
    for (int pass = 0; pass < passes_; ++pass) {
      for (png_uint_32 row = 0; row < height; ++row) {
        png_read_row(png_, pixels + row * stride, nullptr);
      }
    }
    png_read_end(png_, nullptr);
    return true;
  }

  void require(bool done) const {
    if (!done) throw InputError(name_, "a whole PNG image", source_.message.data());
  }

  const std::string& name_;
  Source source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  void (*convert_)(png_structp) = nullptr;
  int passes_ = 1;
};

/// Checks the size before anything is allocated for it.
void require_plausible(const PngHeader& header, std::size_t file_size, const std::string& name) {
  require_image_size(header.size.width, header.size.height, name);
  const std::size_t bits = header.size.pixels() * static_cast<std::size_t>(header.bit_depth);
  if (bits / 8 / most_inflation > file_size) {
    throw InputError(name, "a whole PNG image",
                     fmt::format("{} bytes, too few for {}×{} pixels", file_size, header.size.width,
                                 header.size.height));
  }
}

void to_native_16_bit(png_structp png) {
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
}

void to_8_bit_colors(png_structp png) {
  png_set_expand(png);
  png_set_strip_16(png);
  png_set_gray_to_rgb(png);
  png_set_strip_alpha(png);
}

}  // namespace

PngHeader parse_png_header(std::string_view bytes, const std::string& name) {
  if (!is_png(bytes) || bytes.size() < 26 || bytes.substr(12, 4) != "IHDR") {
    throw InputError(name, "a PNG image",
                     is_png(bytes) ? "one cut off in its head" : "other bytes");
  }
  PngHeader header;
  header.size = {big_endian(bytes.substr(16)), big_endian(bytes.substr(20))};
  header.bit_depth = static_cast<unsigned char>(bytes[24]);
  header.color_type = static_cast<unsigned char>(bytes[25]);
  require_image_size(header.size.width, header.size.height, name);
  return header;
}

std::string describe(const PngHeader& header) {
  const char* type = "colour";
  if (header.color_type == 0) type = "grey";
  if (header.color_type == 3) type = "palette";
  if (header.color_type == 4) type = "grey with alpha";
  if (header.color_type == 6) type = "colour with alpha";
  return fmt::format("a PNG of {}-bit {}", header.bit_depth, type);
}

DepthImage parse_depth_png(std::string_view bytes, const std::string& name) {
  constexpr const char* expected = "a PNG of 16-bit grey";
  if (is_jpeg(bytes)) throw InputError(name, expected, "a JPEG image");
  const PngHeader header = parse_png_header(bytes, name);
  if (header.bit_depth != 16 || header.color_type != PNG_COLOR_TYPE_GRAY) {
    throw InputError(name, expected, describe(header));
  }
  require_plausible(header, bytes.size(), name);
  Decoder decoder(bytes, name);
  decoder.begin(to_native_16_bit);
  DepthImage image{header.size, std::vector<std::uint16_t>(header.size.pixels())};
  if (decoder.row_bytes() != 2 * std::size_t{header.size.width}) {
    throw InputError(name, expected, "another image");
  }
  decoder.read(reinterpret_cast<png_bytep>(image.values.data()), header.size.height);
  return image;
}

ColorImage parse_color_png(std::string_view bytes, const std::string& name) {
  const PngHeader header = parse_png_header(bytes, name);
  require_plausible(header, bytes.size(), name);
  Decoder decoder(bytes, name);
  decoder.begin(to_8_bit_colors);
  if (decoder.row_bytes() != 3 * std::size_t{header.size.width}) {
    throw InputError(name, "a PNG that can be made colours of 8 bits", describe(header));
  }
  ColorImage image{header.size, Colors(static_cast<Eigen::Index>(header.size.pixels()), 3)};
  decoder.read(image.pixels.data(), header.size.height);
  return image;
}

}  // namespace symscene
