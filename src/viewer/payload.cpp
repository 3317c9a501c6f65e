#include "viewer/payload.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "symscene/core/error.hpp"
#include "viewer/base64.hpp"

namespace symscene {
namespace {

using nlohmann::json;

// Steps of 16 bits over the box keep a coordinate within 0.1 mm up to this extent. [m]
constexpr float quantized_extent = 2 * 0.0001F * 65535;

json to_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

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
          {"min", to_json(box.min.cast<double>())},
          {"step", to_json(extent.cast<double>() / 65535.0)}};
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

json positions(const Points& points) {
  if (!points.allFinite()) {
    throw InputError("the page", "finite positions", "a position that is not finite");
  }
  const Box box = bounding_box(points);
  const bool fits = points.rows() > 0 && box.extent().maxCoeff() < quantized_extent;
  return fits ? quantized_positions(points, box) : float_positions(points);
}

// A normal that is not finite counts as none.
std::string normals(const Points& normals) {
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

json to_json(const PointCloud& cloud) {
  const auto color_bytes = static_cast<std::size_t>(cloud.colors.size());
  return {{"positions", positions(cloud.positions)},
          {"normals", normals(cloud.normals)},
          {"colors", base64({cloud.colors.data(), color_bytes})}};
}

std::string indices(const PointIndices& points, Index count) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(points.size() * 4);
  for (const Index i : points) {
    if (i >= count) {
      throw InputError("an object's points", "indices below " + std::to_string(count),
                       std::to_string(i));
    }
    append_little_endian(bytes, i);
  }
  return base64(bytes);
}

json to_json(const ScoredAxis& scored) {
  return {{"point", to_json(scored.axis.point)},
          {"direction", to_json(scored.axis.direction)},
          {"score", scored.score}};
}

json to_json(const ScoredPlane& scored) {
  return {{"point", to_json(scored.plane.point)},
          {"normal", to_json(scored.plane.normal)},
          {"score", scored.score}};
}

json to_json(const FunnelStep& step) { return {{"step", step.step}, {"count", step.count}}; }

json to_json(const StageTime& time) { return {{"stage", time.stage}, {"seconds", time.seconds}}; }

json to_json(const Rejection& rejection) {
  return {{"kind", rejection.kind},
          {"reason", rejection.reason},
          {"value", rejection.value},
          {"bound", rejection.bound},
          {"size", rejection.size}};
}

template <class Item>
json list(const std::vector<Item>& items) {
  json result = json::array();
  for (const Item& item : items) result.push_back(to_json(item));
  return result;
}

json to_json(const SceneObject& object, std::size_t id, const PointCloud& completed, Index count) {
  return {{"id", id},
          {"score", object.score},
          {"points", indices(object.points, count)},
          {"rotational", list(object.rotational)},
          {"reflectional", list(object.reflectional)},
          {"centroid", to_json(object.centroid)},
          {"completed", to_json(completed)}};
}

json objects(const SegmentationResult& result) {
  const std::size_t completed = result.completed.size();
  if (completed != 0 && completed != result.objects.size()) {
    throw InputError("the page", "completed points for every object or for none",
                     std::to_string(completed) + " of " + std::to_string(result.objects.size()));
  }
  json list = json::array();
  for (std::size_t id = 0; id < result.objects.size(); ++id) {
    list.push_back(to_json(result.objects[id], id, completed ? result.completed[id] : PointCloud{},
                           result.cloud.size()));
  }
  return list;
}

}  // namespace

json make_payload(const SegmentationResult& result, const PageOptions& options) {
  options.validate();
  const double length = options.table ? options.table->normal.norm() : 1.0;
  const Eigen::Vector3d up = options.table
                                 ? Eigen::Vector3d(options.table->normal / length)
                                 : options.up.value_or(Eigen::Vector3d::UnitZ()).normalized();
  return {{"version", 1},
          {"title", options.title},
          {"note", options.note},
          {"up", to_json(up)},
          {"table", options.table ? json(-options.table->offset / length) : json(nullptr)},
          {"cloud", to_json(result.cloud)},
          {"objects", objects(result)},
          {"timings", list(result.timings)},
          {"funnel", list(result.funnel)},
          {"rejected", list(result.rejected)}};
}

}  // namespace symscene
