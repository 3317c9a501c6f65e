#include "io/gif_writer.hpp"

#include <gtest/gtest.h>

#include <random>

#include "gif_frames.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

#ifdef SYMSCENE_HAS_GIF

using Pixels = std::vector<std::uint8_t>;

constexpr ImageSize size{37, 21};

std::vector<PaletteColor> random_palette(std::mt19937& random, std::size_t colors) {
  std::vector<PaletteColor> palette(colors);
  for (PaletteColor& color : palette)
    for (std::uint8_t& channel : color) channel = static_cast<std::uint8_t>(random() % 256);
  return palette;
}

/// Frames of which each changes a random rectangle of the one before; some change nothing.
std::vector<Pixels> random_frames(std::mt19937& random, std::size_t colors, std::size_t count) {
  std::vector<Pixels> frames{Pixels(size.pixels())};
  while (frames.size() < count) {
    Pixels next = frames.back();
    const std::size_t left = random() % size.width, top = random() % size.height;
    for (std::size_t y = top; y < top + random() % (size.height - top + 1); ++y)
      for (std::size_t x = left; x < left + random() % (size.width - left + 1); ++x)
        next[y * size.width + x] = static_cast<std::uint8_t>(random() % colors);
    frames.push_back(next);
  }
  return frames;
}

std::vector<unsigned char> colors_of(const Pixels& frame,
                                     const std::vector<PaletteColor>& palette) {
  std::vector<unsigned char> colors;
  for (const std::uint8_t pixel : frame)
    colors.insert(colors.end(), palette[pixel].begin(), palette[pixel].end());
  return colors;
}

TEST(GifWriter, EveryFrameIsReadBackAsItWasWritten) {
  std::mt19937 random(1);
  for (const std::size_t colors : {1UL, 2UL, 17UL, GifWriter::max_colors}) {
    const std::vector<PaletteColor> palette = random_palette(random, colors);
    const std::vector<Pixels> frames = random_frames(random, colors, 12);
    GifWriter writer(size, palette);
    for (const Pixels& frame : frames) writer.add(frame, 0.1);
    const std::vector<testing::GifFrame> read = testing::gif_frames(writer.finish());
    ASSERT_EQ(read.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_EQ(read[i].width, static_cast<int>(size.width));
      EXPECT_EQ(read[i].height, static_cast<int>(size.height));
      EXPECT_EQ(read[i].colors, colors_of(frames[i], palette)) << "frame " << i;
    }
  }
}

TEST(GifWriter, SumsOfDurationsAreExact) {
  const std::vector<PaletteColor> palette(2);
  GifWriter writer(size, palette);
  for (int i = 0; i < 30; ++i) writer.add(Pixels(size.pixels()), 1.0 / 30.0);
  int sum = 0;
  for (const testing::GifFrame& frame : testing::gif_frames(writer.finish())) sum += frame.delay;
  EXPECT_EQ(sum, 100);
}

TEST(GifWriter, RefusesWhatIsNoAnimation) {
  const std::vector<PaletteColor> palette(3);
  EXPECT_THROW(GifWriter({0, 4}, palette), InputError);
  EXPECT_THROW(GifWriter({70000, 4}, palette), InputError);
  EXPECT_THROW(GifWriter(size, {}), InputError);
  EXPECT_THROW(GifWriter(size, std::vector<PaletteColor>(256)), InputError);
  GifWriter writer(size, palette);
  EXPECT_THROW(writer.add(Pixels(5), 0.1), InputError);
  EXPECT_THROW(writer.add(Pixels(size.pixels(), 3), 0.1), InputError);
  EXPECT_THROW(writer.finish(), InputError);
}

#else

TEST(GifWriter, NamesThePackageThatIsMissing) {
  try {
    GifWriter({4, 4}, std::vector<PaletteColor>(1));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(error.expected().find("libgif-dev"), std::string::npos);
  }
}

#endif

}  // namespace
}  // namespace symscene
