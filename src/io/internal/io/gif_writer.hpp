#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "symscene/io/image.hpp"

namespace symscene {

/// Whether this build writes GIFs: libgif-dev was installed when it was configured.
bool has_gif();

using PaletteColor = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// Writes an animated GIF that repeats without end. A frame stores only the rectangle in which it
/// differs from the frame before.
class GifWriter {
 public:
  static constexpr std::size_t max_colors = 255;  ///< one more stands for an unchanged pixel

  /// Throws InputError if this build has no giflib, the image is empty or more than 65,535 pixels
  /// wide or high, or there are no colours or too many.
  GifWriter(ImageSize size, std::span<const PaletteColor> palette);
  ~GifWriter();
  GifWriter(const GifWriter&) = delete;
  GifWriter& operator=(const GifWriter&) = delete;

  /// Adds a frame that is shown for `duration` [s]; GIF counts times in hundredths of a second, and
  /// sums of durations are exact to one. `pixels`: one index into the palette per pixel, rows from
  /// the top. Throws InputError if there are more or fewer pixels, or an index is outside.
  void add(std::span<const std::uint8_t> pixels, double duration);

  /// The file, after which no frame may be added. Throws InputError if it has no frames.
  std::string finish();

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace symscene
