#include "ros_camera_info.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "camera_formats.hpp"
#include "image_formats.hpp"

namespace symscene {
namespace {

/// A list of numbers, as such or as the data of a matrix.
JsonCursor list_of(const JsonCursor& root, const char* in_file, const char* in_ros1,
                   const char* in_ros2) {
  if (const auto matrix = root.find(in_file)) return matrix->at("data");
  if (const auto list = root.find(in_ros1)) return *list;
  return root.at(in_ros2);
}

/// In the message the members lack the prefix.
JsonCursor size_of(const JsonCursor& root, const char* in_file, const char* in_message) {
  const auto size = root.find(in_file);
  return size ? *size : root.at(in_message);
}

/// Coefficients in the order k1 k2 p1 p2 k3; the model rational_polynomial has more, which may be
/// 0.
LensDistortion plumb_bob_of(const JsonCursor& list) {
  constexpr std::size_t known = 5;
  const std::vector<JsonCursor> items = list.items();
  std::array<double, known> numbers{};
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double number = items[i].number();
    if (i < known)
      numbers[i] = number;
    else if (number != 0.0)
      items[i].fail("0: SymScene has the distortion k1, k2, p1, p2, k3 (plumb_bob) only");
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
}

}  // namespace

Index whole_number(const JsonCursor& value, std::size_t most) {
  const double number = value.number();
  if (!(number >= 1.0) || number > static_cast<double>(most) || number != std::floor(number))
    value.fail(fmt::format("a whole number from 1 to {}", most));
  return static_cast<Index>(number);
}

bool is_ros_camera_info(const JsonCursor& root) {
  for (const char* member : {"camera_matrix", "K", "k"}) {
    if (root.find(member)) return true;
  }
  return false;
}

CameraModel ros_camera_info(const JsonCursor& root, const std::string& name) {
  const std::vector<JsonCursor> matrix = list_of(root, "camera_matrix", "K", "k").items(9);
  CameraModel camera;
  camera.intrinsics = {whole_number(size_of(root, "image_width", "width"), largest_image),
                       whole_number(size_of(root, "image_height", "height"), largest_image),
                       matrix[0].number(),
                       matrix[4].number(),
                       matrix[2].number(),
                       matrix[5].number()};
  require_camera(camera.intrinsics, name);
  if (const auto model = root.find("distortion_model")) {
    const std::string text = model->string();
    if (text != "plumb_bob" && text != "rational_polynomial" && !text.empty())
      model->fail("\"plumb_bob\"");
  }
  camera.distortion = plumb_bob_of(list_of(root, "distortion_coefficients", "D", "d"));
  return camera;
}

}  // namespace symscene
