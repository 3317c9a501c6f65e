#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "image_sequence.hpp"

namespace symscene {

/// An image and when it was taken. [s]
struct TimedImage {
  double time = 0.0;
  std::filesystem::path file;
};

/// The images of a list with lines of "time path", by rising time. Empty lines and lines after #
/// are skipped. Throws InputError if a line is another or a path leaves the folder of the list.
std::vector<TimedImage> read_image_list(const std::filesystem::path& list);

/// The frames of a list with lines of "time path time path", one path below depth/: the first time
/// of a line is the frame's. Throws InputError as read_image_list() does.
std::vector<ImageFrame> read_associations(const std::filesystem::path& list);

/// The image nearest in time, nothing if none is within `tolerance`. `images` by rising time. [s]
std::filesystem::path nearest_image(const std::vector<TimedImage>& images, double time,
                                    double tolerance);

/// How far apart images of one frame may have been taken. [s]
constexpr double association_tolerance = 0.02;

}  // namespace symscene
