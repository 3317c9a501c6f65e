#pragma once

#include <cstddef>
#include <vector>

namespace symscene {

/// Bounds of the values in any rectangle of an image, by a pyramid of minima and maxima.
class RangePyramid {
 public:
  struct Range {
    float min, max;
  };
  /// Pixels from low to high, both included, all inside the image.
  struct Rectangle {
    int low_u, low_v, high_u, high_v;
  };

  RangePyramid(std::vector<float> values, std::size_t width, std::size_t height);

  const float* values() const { return levels_[0].min.data(); }
  int width() const { return static_cast<int>(levels_[0].width); }
  int height() const { return static_cast<int>(levels_[0].height); }
  float max() const { return max_; }

  /// Bounds of the values in a rectangle; they may be loose.
  Range bounds(const Rectangle& pixels) const;

 private:
  struct Level {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<float> min;
    std::vector<float> max;  ///< empty where it equals min

    const std::vector<float>& maxima() const { return max.empty() ? min : max; }
  };
  static Level halved(const Level& fine);

  std::vector<Level> levels_;
  float max_ = 0.0F;
};

}  // namespace symscene
