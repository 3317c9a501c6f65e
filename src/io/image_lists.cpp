#include "image_lists.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "image_files.hpp"
#include "io/atomic_file.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

/// The images of a line of "time path" pairs.
std::vector<TimedImage> parse_pairs(const std::vector<std::string_view>& words, const fs::path& dir,
                                    const std::string& where) {
  std::vector<TimedImage> images;
  for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
    const auto time = to_number<double>(words[i]);
    if (!time || !std::isfinite(*time)) throw InputError(where, "a time", in_quotes(words[i]));
    images.push_back({*time, listed_file(dir, words[i + 1], where)});
  }
  return images;
}

/// Calls take(images) for every line, each of which must have `count` images.
template <class Take>
void for_each_line(const fs::path& list, std::size_t count, const char* expected,
                   const Take& take) {
  const std::string bytes = read_file(list);
  std::string_view text = bytes;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::vector<std::string_view> words = words_of(without_comment(take_line(text)));
    if (words.empty()) continue;
    const std::string where = fmt::format("{}: line {}", list.string(), line);
    if (words.size() != 2 * count) {
      throw InputError(where, expected, fmt::format("{} words", words.size()));
    }
    take(parse_pairs(words, list.parent_path(), where));
  }
}

bool is_depth(const TimedImage& image) {
  return image.file.parent_path().filename().string().starts_with("depth");
}

}  // namespace

std::vector<TimedImage> read_image_list(const fs::path& list) {
  std::vector<TimedImage> images;
  for_each_line(list, 1, "a time and the path of an image",
                [&](std::vector<TimedImage> line) { images.push_back(std::move(line.front())); });
  std::stable_sort(images.begin(), images.end(),
                   [](const TimedImage& a, const TimedImage& b) { return a.time < b.time; });
  return images;
}

std::vector<ImageFrame> read_associations(const fs::path& list) {
  constexpr const char* expected = "time path time path, one of them in depth/";
  std::vector<ImageFrame> frames;
  for_each_line(list, 2, expected, [&](const std::vector<TimedImage>& line) {
    const std::size_t depth = is_depth(line[0]) ? 0 : 1;
    if (!is_depth(line[depth])) throw InputError(list.string(), expected, "another path");
    frames.push_back({line[0].time, line[depth].file, line[1 - depth].file, std::nullopt});
  });
  std::stable_sort(frames.begin(), frames.end(),
                   [](const ImageFrame& a, const ImageFrame& b) { return a.time < b.time; });
  return frames;
}

fs::path nearest_image(const std::vector<TimedImage>& images, double time, double tolerance) {
  auto nearest = std::lower_bound(images.begin(), images.end(), time,
                                  [](const TimedImage& image, double t) { return image.time < t; });
  if (nearest == images.end() ||
      (nearest != images.begin() && time - (nearest - 1)->time < nearest->time - time)) {
    if (nearest == images.begin()) return {};
    --nearest;
  }
  return std::abs(nearest->time - time) <= tolerance ? nearest->file : fs::path();
}

}  // namespace symscene
