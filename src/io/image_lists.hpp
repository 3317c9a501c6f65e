#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "image_sequence.hpp"

namespace symscene {

/// An image and its time. [s]
struct TimedImage {
  double time = 0.0;
  std::filesystem::path file;
};

/// Reads a list with lines of "time path", and sorts it by time. Empty lines and text after # are
/// skipped. Throws InputError if a line is not of this form or a path leaves the folder of the
/// list.
std::vector<TimedImage> read_image_list(const std::filesystem::path& list);

/// Reads a list with lines of "time path time path", one of the paths below depth/. The time of a
/// frame is the first one of its line. Throws InputError as read_image_list() does.
std::vector<ImageFrame> read_associations(const std::filesystem::path& list);

/// The image nearest in time; empty if none is within `tolerance` [s]. `images` are sorted by time.
std::filesystem::path nearest_image(const std::vector<TimedImage>& images, double time,
                                    double tolerance);

/// Largest difference in time of the depth and colour image of a frame. [s]
constexpr double association_tolerance = 0.02;

}  // namespace symscene
