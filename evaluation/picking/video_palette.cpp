#include "video_palette.hpp"

#include <algorithm>
#include <cmath>

namespace symscene {
namespace {

constexpr std::size_t shades = 16;
constexpr float darkest = 0.4F;  // of a surface that is seen from the side
constexpr PaletteColor background_color{246, 247, 249};

/// The robot, its hand, the bin, the table, then objects in the colours of the viewer.
constexpr std::array<PaletteColor, 15> hues{{{205, 210, 217},
                                             {95, 104, 116},
                                             {165, 150, 125},
                                             {226, 214, 192},
                                             {0, 119, 187},
                                             {238, 119, 51},
                                             {0, 158, 115},
                                             {204, 51, 119},
                                             {225, 170, 30},
                                             {86, 180, 233},
                                             {140, 86, 200},
                                             {200, 60, 40},
                                             {120, 160, 40},
                                             {0, 150, 160},
                                             {240, 130, 170}}};
constexpr std::size_t first_object = 4;
static_assert(1 + hues.size() * shades <= GifWriter::max_colors);

std::size_t hue_of(RecordedKind kind, std::size_t object) {
  switch (kind) {
    case RecordedKind::robot:
      return 0;
    case RecordedKind::hand:
      return 1;
    case RecordedKind::bin:
      return 2;
    case RecordedKind::table:
      return 3;
    case RecordedKind::object:
      return first_object + object % (hues.size() - first_object);
  }
  return 0;
}

PaletteColor scaled(const PaletteColor& color, float factor) {
  PaletteColor result{};
  for (std::size_t k = 0; k < color.size(); ++k)
    result.at(k) = static_cast<std::uint8_t>(std::lround(factor * color.at(k)));
  return result;
}

}  // namespace

VideoPalette::VideoPalette() : colors_{background_color} {
  for (const PaletteColor& hue : hues)
    for (std::size_t shade = 0; shade < shades; ++shade) {
      const float share = static_cast<float>(shade) / static_cast<float>(shades - 1);
      colors_.push_back(scaled(hue, darkest + (1.0F - darkest) * share));
    }
}

std::vector<std::uint8_t> VideoPalette::hues_of(const std::vector<RecordedSolid>& solids) {
  std::vector<std::uint8_t> result;
  std::size_t objects = 0;
  for (const RecordedSolid& solid : solids) {
    result.push_back(static_cast<std::uint8_t>(hue_of(solid.kind, objects)));
    if (solid.kind == RecordedKind::object) ++objects;
  }
  return result;
}

std::uint8_t VideoPalette::shaded(std::uint8_t hue, float cosine) {
  constexpr auto brightest = static_cast<float>(shades - 1);
  const auto shade = std::lround(std::clamp(cosine, 0.0F, 1.0F) * brightest);
  return static_cast<std::uint8_t>(1 + hue * static_cast<long>(shades) + shade);
}

}  // namespace symscene
