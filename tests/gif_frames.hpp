#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#ifdef SYMSCENE_HAS_GIF
#include <cstring>

#include <gif_lib.h>
#endif

namespace symscene::testing {

/// An image of a GIF: red, green and blue per pixel, and how long it is shown [1/100 s].
struct GifFrame {
  int width = 0, height = 0;
  std::vector<unsigned char> colors;
  int delay = 0;
};

#ifdef SYMSCENE_HAS_GIF

/// Reads a GIF with giflib and draws each image over the one before.
inline std::vector<GifFrame> gif_frames(const std::string& bytes) {
  struct Source {
    const std::string& bytes;
    std::size_t at = 0;
  } source{bytes};
  const auto read = [](GifFileType* file, GifByteType* to, int count) {
    auto& from = *static_cast<Source*>(file->UserData);
    const std::size_t length =
        std::min(static_cast<std::size_t>(count), from.bytes.size() - from.at);
    std::memcpy(to, from.bytes.data() + from.at, length);
    from.at += length;
    return static_cast<int>(length);
  };
  int error = 0;
  GifFileType* const gif = DGifOpen(&source, read, &error);
  if (gif == nullptr || DGifSlurp(gif) != GIF_OK) throw std::runtime_error("not a GIF");
  std::vector<GifFrame> frames;
  GifFrame canvas{gif->SWidth, gif->SHeight, {}, 0};
  canvas.colors.resize(3 * static_cast<std::size_t>(gif->SWidth) *
                       static_cast<std::size_t>(gif->SHeight));
  for (int i = 0; i < gif->ImageCount; ++i) {
    const SavedImage& image = gif->SavedImages[i];
    GraphicsControlBlock control{};
    DGifSavedExtensionToGCB(gif, i, &control);
    const GifImageDesc& part = image.ImageDesc;
    for (int k = 0; k < part.Width * part.Height; ++k) {
      if (image.RasterBits[k] == control.TransparentColor) continue;
      const GifColorType color = gif->SColorMap->Colors[image.RasterBits[k]];
      const int pixel = (part.Top + k / part.Width) * canvas.width + part.Left + k % part.Width;
      const auto at = 3 * static_cast<std::size_t>(pixel);
      canvas.colors[at] = color.Red;
      canvas.colors[at + 1] = color.Green;
      canvas.colors[at + 2] = color.Blue;
    }
    canvas.delay = control.DelayTime;
    frames.push_back(canvas);
  }
  DGifCloseFile(gif, &error);
  return frames;
}

#endif

}  // namespace symscene::testing
