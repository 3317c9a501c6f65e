#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "symscene/core/error.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

using ImagePoints = std::vector<cv::Point2f>;

/// A view of the pixels; OpenCV does not write to them. Throws InputError if the number of pixels
/// is not that of the size.
inline cv::Mat image_of(std::span<const std::uint8_t> grey, Index width, Index height) {
  if (grey.size() != std::size_t{width} * height)
    throw InputError("image of a board", fmt::format("{}×{} pixels", width, height),
                     fmt::format("{}", grey.size()));
  return {static_cast<int>(height), static_cast<int>(width), CV_8UC1,
          const_cast<std::uint8_t*>(grey.data())};
}

}  // namespace symscene
