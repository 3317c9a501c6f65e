#include "io/gif_writer.hpp"

#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_GIF
#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include <fmt/format.h>
#include <gif_lib.h>
#endif

namespace symscene {

#ifndef SYMSCENE_HAS_GIF

struct GifWriter::Encoder {};

bool has_gif() { return false; }

GifWriter::GifWriter(ImageSize /*size*/, std::span<const PaletteColor> /*palette*/) {
  throw InputError("GIF to write", "a build with giflib (install libgif-dev and build again)",
                   "one without");
}

void GifWriter::add(std::span<const std::uint8_t> /*pixels*/, double /*duration*/) {}

std::string GifWriter::finish() { return {}; }

#else

namespace {

constexpr const char* gif_to_write = "GIF to write";
constexpr int colors_in_file = 256;
constexpr int unchanged = 255;

/// giflib is C: nothing may be thrown through it.
int append(GifFileType* gif, const GifByteType* bytes, int count) {
  try {
    static_cast<std::string*>(gif->UserData)
        ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
    return count;
  } catch (...) {
    return 0;
  }
}

/// The bytes go to memory, so nothing but memory can be short.
void require(int result) {
  if (result == GIF_ERROR) throw std::bad_alloc();
}

/// Half open, in pixels.
struct Rectangle {
  std::size_t left, top, right, bottom;
};

/// The smallest rectangle that holds every pixel that differs; one pixel if none does.
Rectangle difference(std::span<const std::uint8_t> before, std::span<const std::uint8_t> now,
                     std::size_t width) {
  Rectangle box{width, now.size() / width, 0, 0};
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] == before[i]) continue;
    const std::size_t x = i % width, y = i / width;
    box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
           std::max(box.bottom, y + 1)};
  }
  return box.right == 0 ? Rectangle{0, 0, 1, 1} : box;
}

}  // namespace

struct GifWriter::Encoder {
  ImageSize size;
  std::size_t colors;
  std::string bytes;
  GifFileType* gif = nullptr;
  std::vector<std::uint8_t> before;  ///< pixels of the last frame
  double end = 0.0;                  ///< of the frames so far [s]

  Encoder(ImageSize image, std::span<const PaletteColor> palette)
      : size(image), colors(palette.size()) {
    int error = 0;
    gif = EGifOpen(&bytes, append, &error);
    if (gif == nullptr) throw std::bad_alloc();
    EGifSetGifVersion(gif, true);
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  ~Encoder() { close(); }

  bool close() {
    int error = 0;
    GifFileType* const open = std::exchange(gif, nullptr);
    return open == nullptr || EGifCloseFile(open, &error) == GIF_OK;
  }

  void begin(std::span<const PaletteColor> palette) {
    std::array<GifColorType, colors_in_file> entries{};
    for (std::size_t i = 0; i < palette.size(); ++i)
      entries.at(i) = {palette[i][0], palette[i][1], palette[i][2]};
    const std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)> map(
        GifMakeMapObject(colors_in_file, entries.data()), GifFreeMapObject);
    if (!map) throw std::bad_alloc();
    require(EGifPutScreenDesc(gif, static_cast<int>(size.width), static_cast<int>(size.height), 8,
                              0, map.get()));
    repeat_for_ever();
  }

  void repeat_for_ever() {
    constexpr std::array<std::uint8_t, 3> times{1, 0, 0};  // 0: without end
    require(EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE));
    require(EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0"));
    require(EGifPutExtensionBlock(gif, static_cast<int>(times.size()), times.data()));
    require(EGifPutExtensionTrailer(gif));
  }

  void put_control(double duration, bool is_first) {
    const double start = end;
    end += duration;
    GraphicsControlBlock control{};
    control.DisposalMode = DISPOSE_DO_NOT;
    control.DelayTime = static_cast<int>(std::round(100.0 * end) - std::round(100.0 * start));
    control.TransparentColor = is_first ? NO_TRANSPARENT_COLOR : unchanged;
    std::array<GifByteType, 4> block{};
    const std::size_t length = EGifGCBToExtension(&control, block.data());
    require(EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(length), block.data()));
  }

  void put_rectangle(std::span<const std::uint8_t> pixels, const Rectangle& box, bool is_first) {
    const auto number = [](std::size_t value) { return static_cast<int>(value); };
    const std::size_t width = box.right - box.left;
    require(EGifPutImageDesc(gif, number(box.left), number(box.top), number(width),
                             number(box.bottom - box.top), false, nullptr));
    std::vector<std::uint8_t> row(width);
    for (std::size_t y = box.top; y < box.bottom; ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        const std::size_t i = y * size.width + box.left + x;
        row[x] = !is_first && pixels[i] == before[i] ? std::uint8_t{unchanged} : pixels[i];
      }
      require(EGifPutLine(gif, row.data(), number(width)));
    }
  }
};

bool has_gif() { return true; }

GifWriter::GifWriter(ImageSize size, std::span<const PaletteColor> palette) {
  constexpr Index longest = 65535;
  if (size.pixels() == 0 || size.width > longest || size.height > longest)
    throw InputError(gif_to_write, fmt::format("between 1 and {} pixels per edge", longest),
                     fmt::format("{} x {}", size.width, size.height));
  if (palette.empty() || palette.size() > max_colors)
    throw InputError(gif_to_write, fmt::format("between 1 and {} colours", max_colors),
                     std::to_string(palette.size()));
  encoder_ = std::make_unique<Encoder>(size, palette);
  encoder_->begin(palette);
}

void GifWriter::add(std::span<const std::uint8_t> pixels, double duration) {
  Encoder& encoder = *encoder_;
  if (pixels.size() != encoder.size.pixels())
    throw InputError(gif_to_write, fmt::format("{} pixels", encoder.size.pixels()),
                     std::to_string(pixels.size()));
  const std::uint8_t greatest = *std::max_element(pixels.begin(), pixels.end());
  if (greatest >= encoder.colors)
    throw InputError(gif_to_write, fmt::format("indices below {}", encoder.colors),
                     std::to_string(greatest));
  const bool is_first = encoder.before.empty();
  const Rectangle box = is_first ? Rectangle{0, 0, encoder.size.width, encoder.size.height}
                                 : difference(encoder.before, pixels, encoder.size.width);
  encoder.put_control(duration, is_first);
  encoder.put_rectangle(pixels, box, is_first);
  encoder.before.assign(pixels.begin(), pixels.end());
}

std::string GifWriter::finish() {
  if (encoder_->before.empty()) throw InputError(gif_to_write, "frames", "none");
  if (!encoder_->close()) throw std::bad_alloc();
  return std::move(encoder_->bytes);
}

#endif

GifWriter::~GifWriter() = default;

}  // namespace symscene
