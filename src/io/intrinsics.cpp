#include "symscene/io/intrinsics.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "camera_formats.hpp"
#include "image_formats.hpp"
#include "io/atomic_file.hpp"
#include "io/json_cursor.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

constexpr const char* six_numbers = "six numbers: width height fx fy cx cy";

Index to_index(double value, const std::string& name) {
  if (value >= 1.0 && value <= static_cast<double>(largest_image) && value == std::floor(value)) {
    return static_cast<Index>(value);
  }
  throw InputError(name, "width and height in whole pixels", fmt::format("{}", value));
}

}  // namespace

void require_camera(const CameraIntrinsics& camera, const std::string& name) {
  for (const double focal : {camera.fx, camera.fy}) {
    if (std::isfinite(focal) && focal > 0.0) continue;
    throw InputError(name, "focal lengths above 0", fmt::format("{}", focal));
  }
  for (const double center : {camera.cx, camera.cy}) {
    if (std::isfinite(center)) continue;
    throw InputError(name, "a principal point of finite numbers", fmt::format("{}", center));
  }
  if (camera.width != 0 || camera.height != 0) {
    require_image_size(camera.width, camera.height, name);
  }
}

CameraIntrinsics parse_intrinsics(std::string_view text, const std::string& name) {
  std::array<double, 6> numbers{};
  for (double& number : numbers) {
    const std::string_view word = next_word(text);
    if (word.empty()) throw InputError(name, six_numbers, "the end of the file");
    const auto value = to_number<double>(word);
    if (!value) throw InputError(name, six_numbers, in_quotes(word));
    number = *value;
  }
  const std::string_view extra = next_word(text);
  if (!extra.empty()) throw InputError(name, six_numbers, "more: " + in_quotes(extra));
  const CameraIntrinsics camera{to_index(numbers[0], name),
                                to_index(numbers[1], name),
                                numbers[2],
                                numbers[3],
                                numbers[4],
                                numbers[5]};
  require_camera(camera, name);
  return camera;
}

CameraIntrinsics read_intrinsics(const std::filesystem::path& path) {
  return parse_intrinsics(read_file(path), path.string());
}

std::string format_intrinsics(const CameraIntrinsics& camera) {
  return fmt::format("{} {} {} {} {} {}\n", camera.width, camera.height, camera.fx, camera.fy,
                     camera.cx, camera.cy);
}

CameraIntrinsics parse_intrinsics_json(std::string_view text, const std::string& name) {
  const Json document = parse_json(text, name);
  const JsonCursor root(document, name);
  const auto matrix = root.at("intrinsic_matrix").items(9);
  const CameraIntrinsics camera{to_index(root.at("width").number(), name),
                                to_index(root.at("height").number(), name),
                                matrix[0].number(),
                                matrix[4].number(),
                                matrix[6].number(),
                                matrix[7].number()};
  require_camera(camera, name);
  return camera;
}

}  // namespace symscene
