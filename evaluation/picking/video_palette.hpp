#pragma once

#include <cstdint>
#include <vector>

#include "io/gif_writer.hpp"
#include "symscene/viewer/run_page.hpp"

namespace symscene {

/// The colours of a video: one of the background, then shades of one colour for the robot, its
/// hand, the bin, the table, and for each of eleven objects; further objects repeat these.
class VideoPalette {
 public:
  VideoPalette();

  const std::vector<PaletteColor>& colors() const { return colors_; }
  static constexpr std::uint8_t background = 0;
  /// Which colour each solid has.
  static std::vector<std::uint8_t> hues_of(const std::vector<RecordedSolid>& solids);
  /// The index of a colour at the cosine of the angle between the surface's normal and the ray.
  static std::uint8_t shaded(std::uint8_t hue, float cosine);

 private:
  std::vector<PaletteColor> colors_;
};

}  // namespace symscene
