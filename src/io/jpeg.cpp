#include <array>
#include <csetjmp>
#include <cstdio>  // needed by jpeglib.h
#include <cstring>

#include <jpeglib.h>

#include "image_formats.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Bounds the time per file: a small progressive file can contain many scans of a large image.
constexpr int most_scans = 100;

/// The error message of libjpeg, which leaves a failed call by longjmp: while a call runs, nothing
/// with a destructor may be on the stack above `jump`. `base` is first, so that a pointer to it is
/// also one to the struct.
struct ErrorManager {
  jpeg_error_mgr base;
  std::jmp_buf jump;
  std::array<char, JMSG_LENGTH_MAX> message{};
};

extern "C" void symscene_jpeg_error(j_common_ptr info) {
  auto* errors = reinterpret_cast<ErrorManager*>(info->err);
  errors->base.format_message(info, errors->message.data());
  std::longjmp(errors->jump, 1);
}

/// libjpeg warns of corrupt images and fills them with grey; they are refused.
extern "C" void symscene_jpeg_message(j_common_ptr info, int level) {
  if (level < 0) symscene_jpeg_error(info);
}

extern "C" void symscene_jpeg_progress(j_common_ptr info) {
  const auto* decompress = reinterpret_cast<j_decompress_ptr>(info);
  if (decompress->input_scan_number <= most_scans) return;
  auto* errors = reinterpret_cast<ErrorManager*>(info->err);
  std::strcpy(errors->message.data(), "more than 100 scans");
  std::longjmp(errors->jump, 1);
}

/// Decodes a JPEG with libjpeg.
class Decoder {
 public:
  Decoder(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {
    info_.err = jpeg_std_error(&errors_.base);
    errors_.base.error_exit = symscene_jpeg_error;
    errors_.base.emit_message = symscene_jpeg_message;
    progress_.progress_monitor = symscene_jpeg_progress;
  }
  ~Decoder() { jpeg_destroy_decompress(&info_); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  ImageSize read_header() {
    require(start());
    require_image_size(info_.image_width, info_.image_height, name_);
    return {info_.image_width, info_.image_height};
  }

  /// Decodes the pixels into rows of three bytes per pixel.
  void read(std::uint8_t* pixels) { require(finish(pixels)); }

 private:
  bool start() {
    if (setjmp(errors_.jump) != 0) return false;
    jpeg_create_decompress(&info_);
    info_.progress = &progress_;
    jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(bytes_.data()),
                 static_cast<unsigned long>(bytes_.size()));
    jpeg_read_header(&info_, TRUE);
    return true;
  }

  bool finish(std::uint8_t* pixels) {
    if (setjmp(errors_.jump) != 0) return false;
    info_.out_color_space = JCS_RGB;
    jpeg_start_decompress(&info_);
    const std::size_t stride = 3 * std::size_t{info_.output_width};
    while (info_.output_scanline < info_.output_height) {
      JSAMPROW row = pixels + info_.output_scanline * stride;
      jpeg_read_scanlines(&info_, &row, 1);
    }
    jpeg_finish_decompress(&info_);
    return true;
  }

  void require(bool done) const {
    if (!done) throw InputError(name_, "a whole JPEG image", errors_.message.data());
  }

  std::string_view bytes_;
  const std::string& name_;
  jpeg_decompress_struct info_{};
  jpeg_progress_mgr progress_{};
  ErrorManager errors_{};
};

}  // namespace

ImageSize parse_jpeg_size(std::string_view bytes, const std::string& name) {
  return Decoder(bytes, name).read_header();
}

ColorImage parse_jpeg(std::string_view bytes, const std::string& name) {
  Decoder decoder(bytes, name);
  const ImageSize size = decoder.read_header();
  ColorImage image{size, Colors(static_cast<Eigen::Index>(size.pixels()), 3)};
  decoder.read(image.pixels.data());
  return image;
}

}  // namespace symscene
