// A result as messages of Foxglove's schemas
// (https://docs.foxglove.dev/docs/visualization/message-schemas).
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/base64.hpp"
#include "core/little_endian.hpp"
#include "io/json_cursor.hpp"
#include "io/pose_json.hpp"
#include "io/thinned_surfaces.hpp"
#include "mcap_writer.hpp"
#include "symscene/io/mcap.hpp"

namespace symscene {
namespace {

constexpr const char* what = "result to write as MCAP";
constexpr const char* world = "world";

/// Triangles of all surfaces together: viewers draw them at once, and JSON is long.
constexpr Index most_result_triangles = 30'000;

constexpr double text_height = 0.02;  // m
constexpr double line_width = 0.003;  // m

// Enumerations of the schemas.
constexpr int uint8_field = 1, uint16_field = 3, float32_field = 7;
constexpr int line_list = 2;

Json time_zero() { return {{"sec", 0}, {"nsec", 0}}; }

Json vector_json(const Eigen::Vector3d& v) {
  return {{"x", to_json(v.x(), what)}, {"y", to_json(v.y(), what)}, {"z", to_json(v.z(), what)}};
}

/// Rounded to 10 micrometres, as there are many.
Json point_json(const Eigen::Vector3d& point) {
  return vector_json((point * 1e5).array().round() / 1e5);
}

Json pose_in_schema(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q = orientation_of(pose);
  return {{"position", vector_json(pose.translation())},
          {"orientation",
           {{"x", to_json(q.x(), what)},
            {"y", to_json(q.y(), what)},
            {"z", to_json(q.z(), what)},
            {"w", to_json(q.w(), what)}}}};
}

Json identity_pose() { return pose_in_schema(Eigen::Isometry3d::Identity()); }

/// Hues at steps of the golden angle, so that those of neighbours differ.
Json color_of(std::size_t object, double alpha) {
  const double hue = std::fmod(static_cast<double>(object) * (std::numbers::phi - 1.0), 1.0);
  Json color;
  const std::pair<const char*, double> channels[] = {
      {"r", 0.0}, {"g", 2.0 / 3.0}, {"b", 1.0 / 3.0}};
  for (const auto& [name, shift] : channels) {
    const double distance = std::abs(std::fmod(hue + shift, 1.0) * 6.0 - 3.0) - 1.0;
    color[name] = 0.25 + 0.7 * std::clamp(distance, 0.0, 1.0);
  }
  color["a"] = alpha;
  return color;
}

/// An entity of a scene without primitives.
Json entity(const std::string& id) {
  Json entity = {{"timestamp", time_zero()}, {"frame_id", world},     {"id", id},
                 {"lifetime", time_zero()},  {"frame_locked", false}, {"metadata", Json::array()}};
  for (const char* kind :
       {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"}) {
    entity[kind] = Json::array();
  }
  return entity;
}

Json scene_update(const Json& entities) {
  return {{"deletions", Json::array()}, {"entities", entities}};
}

Json triangles_json(const TriangleMesh& mesh, const Json& color) {
  Json points = Json::array();
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    points.push_back(point_json(mesh.vertices.row(i).cast<double>().transpose()));
  }
  Json indices = Json::array();
  for (Eigen::Index i = 0; i < mesh.triangles.rows(); ++i) {
    for (int corner = 0; corner < 3; ++corner) indices.push_back(mesh.triangles(i, corner));
  }
  return {{"pose", identity_pose()},
          {"points", points},
          {"color", color},
          {"colors", Json::array()},
          {"indices", indices}};
}

/// The middle of an object's points and their greatest distance from it.
struct Extent {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

Extent extent_of(const SegmentationResult& result, const SceneObject& object) {
  Extent extent;
  if (object.points.empty()) return extent;
  for (const Index i : object.points) extent.center += result.cloud.position(i).cast<double>();
  extent.center /= static_cast<double>(object.points.size());
  if (object.centroid) extent.center = *object.centroid;
  for (const Index i : object.points) {
    const Eigen::Vector3d point = result.cloud.position(i).cast<double>();
    extent.radius = std::max(extent.radius, (point - extent.center).norm());
  }
  return extent;
}

std::string label_of(const SceneObject& object, std::size_t id) {
  std::string label = fmt::format("{}: {:.2f}", id, object.rank());
  if (object.symmetry_class) label += fmt::format(" {}", to_string(object.symmetry_class->kind));
  return label;
}

Json text_json(const std::string& text, const Eigen::Vector3d& position) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = position;
  return {{"pose", pose_in_schema(pose)},
          {"billboard", true},
          {"font_size", text_height},
          {"scale_invariant", false},
          {"color", {{"r", 1.0}, {"g", 1.0}, {"b", 1.0}, {"a", 1.0}}},
          {"text", text}};
}

Json objects_message(const SegmentationResult& result) {
  std::vector<TriangleMesh> surfaces(result.objects.size());
  for (std::size_t id = 0; id < std::min(surfaces.size(), result.surfaces.size()); ++id) {
    surfaces[id] = result.surfaces[id].mesh;
  }
  surfaces = thinned_surfaces(surfaces, most_result_triangles).meshes;
  const Eigen::Vector3d up = result.table ? result.table->normal : Eigen::Vector3d::UnitZ();
  Json entities = Json::array();
  for (std::size_t id = 0; id < result.objects.size(); ++id) {
    const SceneObject& object = result.objects[id];
    const Extent extent = extent_of(result, object);
    Json item = entity(fmt::format("object_{}", id));
    if (surfaces[id].triangles.rows() != 0) {
      item["triangles"].push_back(triangles_json(surfaces[id], color_of(id, 0.8)));
    }
    item["texts"].push_back(text_json(label_of(object, id), extent.center + extent.radius * up));
    entities.push_back(std::move(item));
  }
  return scene_update(entities);
}

Json axis_json(const RotationAxis& axis, const Extent& extent, const Json& color) {
  const Eigen::Vector3d middle = axis.project(extent.center);
  const Eigen::Vector3d reach = 1.3 * extent.radius * axis.direction;
  return {{"type", line_list},
          {"pose", identity_pose()},
          {"thickness", line_width},
          {"scale_invariant", false},
          {"points", {point_json(middle - reach), point_json(middle + reach)}},
          {"color", color},
          {"colors", Json::array()},
          {"indices", Json::array()}};
}

Json plane_json(const ReflectionPlane& plane, const Extent& extent, const Json& color) {
  const Eigen::Vector3d middle = plane.project(extent.center);
  const Eigen::Matrix<double, 3, 2> sides =
      1.1 * extent.radius * orthonormal_complement(plane.normal);
  TriangleMesh square;
  square.vertices.resize(4, 3);
  const std::array<std::pair<double, double>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (int i = 0; i < 4; ++i) {
    const auto& [u, v] = corners[static_cast<std::size_t>(i)];
    square.vertices.row(i) =
        (middle + u * sides.col(0) + v * sides.col(1)).transpose().cast<float>();
  }
  square.triangles.resize(2, 3);
  square.triangles << 0, 1, 2, 0, 2, 3;
  return triangles_json(square, color);
}

Json symmetries_message(const SegmentationResult& result) {
  Json entities = Json::array();
  for (std::size_t id = 0; id < result.objects.size(); ++id) {
    const SceneObject& object = result.objects[id];
    const Extent extent = extent_of(result, object);
    Json item = entity(fmt::format("symmetries_{}", id));
    for (const ObjectAxis& axis : object.rotational) {
      item["lines"].push_back(axis_json(axis.axis, extent, color_of(id, 1.0)));
    }
    for (const ObjectPlane& plane : object.reflectional) {
      item["triangles"].push_back(plane_json(plane.plane, extent, color_of(id, 0.25)));
    }
    entities.push_back(std::move(item));
  }
  return scene_update(entities);
}

Json poses_message(const SegmentationResult& result) {
  Json poses = Json::array();
  for (const SceneObject& object : result.objects) {
    if (object.box) poses.push_back(pose_in_schema(object.box->T_world_object.transform()));
  }
  return {{"timestamp", time_zero()}, {"frame_id", world}, {"poses", poses}};
}

/// Per point: position, colour, and the number of its first object, from 1; 0 for none.
Json cloud_message(const SegmentationResult& result) {
  const PointCloud& cloud = result.cloud;
  std::vector<std::uint16_t> object_of(cloud.size(), 0);
  for (std::size_t id = result.objects.size(); id-- > 0;) {
    const auto number = static_cast<std::uint16_t>(std::min<std::size_t>(id + 1, 65535));
    for (const Index i : result.objects[id].points) object_of[i] = number;
  }
  std::vector<std::uint8_t> bytes;
  for (Index i = 0; i < cloud.size(); ++i) {
    for (const float value : cloud.position(i)) {
      append_little_endian(bytes, std::bit_cast<std::uint32_t>(value));
    }
    for (int channel = 0; channel < 3; ++channel) {
      bytes.push_back(cloud.has_colors() ? cloud.colors(i, channel) : std::uint8_t{180});
    }
    bytes.push_back(255);
    append_little_endian(bytes, object_of[i]);
  }
  Json fields = Json::array();
  int offset = 0;
  for (const char* name : {"x", "y", "z"}) {
    fields.push_back({{"name", name}, {"offset", offset}, {"type", float32_field}});
    offset += 4;
  }
  for (const char* name : {"red", "green", "blue", "alpha"}) {
    fields.push_back({{"name", name}, {"offset", offset}, {"type", uint8_field}});
    offset += 1;
  }
  fields.push_back({{"name", "object"}, {"offset", offset}, {"type", uint16_field}});
  return {{"timestamp", time_zero()},   {"frame_id", world}, {"pose", identity_pose()},
          {"point_stride", offset + 2}, {"fields", fields},  {"data", base64(bytes)}};
}

Json of_type(const char* type) { return {{"type", type}}; }
Json list_of_objects() { return {{"type", "array"}, {"items", of_type("object")}}; }

/// A JSON schema of the fields of a message. Viewers know the rest by its title.
std::string schema_text(const std::string& title, const Json& properties) {
  return Json{{"title", title}, {"type", "object"}, {"properties", properties}}.dump();
}

Json time_schema() {
  return {{"type", "object"},
          {"title", "time"},
          {"properties", {{"sec", of_type("integer")}, {"nsec", of_type("integer")}}}};
}

Json scene_update_fields() {
  return {{"deletions", list_of_objects()}, {"entities", list_of_objects()}};
}

Json poses_fields() {
  return {
      {"timestamp", time_schema()}, {"frame_id", of_type("string")}, {"poses", list_of_objects()}};
}

Json cloud_fields() {
  return {
      {"timestamp", time_schema()},  {"frame_id", of_type("string")},
      {"pose", of_type("object")},   {"point_stride", of_type("integer")},
      {"fields", list_of_objects()}, {"data", {{"type", "string"}, {"contentEncoding", "base64"}}}};
}

void write_message(McapWriter& writer, const char* topic, const std::string& schema,
                   const Json& fields, const Json& message) {
  const auto channel =
      writer.add_channel({topic, "json", schema, "jsonschema"}, schema_text(schema, fields));
  writer.add_message(channel, 0, format_json(message));
}

}  // namespace

std::string format_result_mcap(const SegmentationResult& result, McapCompression compression) {
  McapWriter writer("", compression);
  write_message(writer, "/cloud", "foxglove.PointCloud", cloud_fields(), cloud_message(result));
  write_message(writer, "/objects", "foxglove.SceneUpdate", scene_update_fields(),
                objects_message(result));
  write_message(writer, "/symmetries", "foxglove.SceneUpdate", scene_update_fields(),
                symmetries_message(result));
  write_message(writer, "/poses", "foxglove.PosesInFrame", poses_fields(), poses_message(result));
  return writer.finish();
}

}  // namespace symscene
