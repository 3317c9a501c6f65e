#include "encoding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base64.hpp"
#include "core/little_endian.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

using nlohmann::json;

// Largest extent at which 16 bits keep a coordinate within 0.1 mm. [m]
constexpr float quantized_extent = 2 * 0.0001F * 65535;

json quantized_positions(const Points& points, const Box& box) {
  const Eigen::Vector3f extent = box.extent();
  std::vector<std::uint8_t> bytes;
  bytes.reserve(static_cast<std::size_t>(points.size()) * 2);
  const Eigen::Vector3f scale = (extent.array() > 0).select(65535.0F / extent.array(), 0.0F);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const float step = (points(i, axis) - box.min[axis]) * scale[axis];
      append_little_endian(bytes,
                           static_cast<std::uint16_t>(std::lround(std::min(step, 65535.0F))));
    }
  }
  return {{"encoding", "u16"},
          {"data", base64(bytes)},
          {"min", encode(box.min.cast<double>())},
          {"step", encode(extent.cast<double>() / 65535.0)}};
}

json float_positions(const Points& points) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(static_cast<std::size_t>(points.size()) * 4);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      append_little_endian(bytes, std::bit_cast<std::uint32_t>(points(i, axis)));
    }
  }
  return {{"encoding", "f32"}, {"data", base64(bytes)}};
}

}  // namespace

json encode(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

json encode_positions(const Points& points) {
  if (!points.allFinite()) {
    throw InputError("the page", "finite positions", "a position that is not finite");
  }
  const Box box = bounding_box(points);
  const bool fits = points.rows() > 0 && box.extent().maxCoeff() < quantized_extent;
  return fits ? quantized_positions(points, box) : float_positions(points);
}

std::string encode_normals(const Points& normals) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(static_cast<std::size_t>(normals.size()));
  for (Eigen::Index i = 0; i < normals.rows(); ++i) {
    const bool finite = normals.row(i).allFinite();
    for (int axis = 0; axis < 3; ++axis) {
      const float value = finite ? std::clamp(normals(i, axis), -1.0F, 1.0F) : 0.0F;
      append_little_endian(bytes, static_cast<std::int8_t>(std::lround(127.0F * value)));
    }
  }
  return base64(bytes);
}

std::string encode_colors(const Colors& colors) {
  return base64({colors.data(), static_cast<std::size_t>(colors.size())});
}

}  // namespace symscene
