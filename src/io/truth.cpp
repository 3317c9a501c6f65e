#include "symscene/io/truth.hpp"

#include <algorithm>

#include "io/json_cursor.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/atomic_file.hpp"

namespace symscene {
namespace {

constexpr const char* what = "truth to write";

bool is_strict(const JsonCursor& symmetry) {
  const auto strict = symmetry.find("strict");
  return !strict || strict->boolean();
}

TrueAxis parse_axis(const JsonCursor& axis) {
  return {{axis.at("p").vector3(), axis.at("d").direction()}, is_strict(axis)};
}

TruePlane parse_plane(const JsonCursor& plane) {
  return {{plane.at("p").vector3(), plane.at("n").direction()}, is_strict(plane)};
}

void require_pose(const JsonCursor& pose) {
  for (const JsonCursor& row : pose.items(4)) {
    for (const JsonCursor& number : row.items(4)) number.number();
  }
}

TrueObject parse_object(const JsonCursor& object, std::optional<Index> cloud_size) {
  TrueObject result;
  if (const auto mesh = object.find("mesh")) result.name = mesh->string();
  if (const auto name = object.find("name")) result.name = name->string();
  if (const auto pose = object.find("pose")) require_pose(*pose);
  if (const auto points = object.find("points")) {
    result.points = points->indices(cloud_size);
  } else if (!object.find("mesh") || !object.find("pose")) {
    object.fail("\"points\", or \"mesh\" and \"pose\"");
  }
  if (const auto axes = object.find("rot")) {
    for (const JsonCursor& axis : axes->items()) result.rotational.push_back(parse_axis(axis));
  }
  if (const auto planes = object.find("refl")) {
    for (const JsonCursor& plane : planes->items())
      result.reflectional.push_back(parse_plane(plane));
  }
  if (const auto sphere = object.find("sphere")) result.sphere = sphere->boolean();
  result.centroid = object.at("centroid").vector3();
  return result;
}

Json format_object(const TrueObject& object) {
  Json json = {{"name", object.name}, {"points", object.points}};
  json["rot"] = Json::array();
  for (const TrueAxis& axis : object.rotational) {
    json["rot"].push_back({{"p", to_json(axis.axis.point, what)},
                           {"d", to_json(axis.axis.direction, what)},
                           {"strict", axis.strict}});
  }
  json["refl"] = Json::array();
  for (const TruePlane& plane : object.reflectional) {
    json["refl"].push_back({{"p", to_json(plane.plane.point, what)},
                            {"n", to_json(plane.plane.normal, what)},
                            {"strict", plane.strict}});
  }
  json["sphere"] = object.sphere;
  json["centroid"] = to_json(object.centroid, what);
  return json;
}

}  // namespace

SceneTruth parse_truth(std::string_view text, const std::string& name,
                       std::optional<Index> cloud_size) {
  const Json document = parse_json(text, name);
  const JsonCursor root(document, name);
  SceneTruth truth;
  truth.table = root.at("table").plane();
  for (const JsonCursor& object : root.at("objects").items()) {
    truth.objects.push_back(parse_object(object, cloud_size));
  }
  return truth;
}

SceneTruth read_truth(const std::filesystem::path& path, std::optional<Index> cloud_size) {
  return parse_truth(read_file(path), path.string(), cloud_size);
}

std::string format_truth(const SceneTruth& truth) {
  Json document;
  document["table"] = to_json(truth.table, what);
  document["objects"] = Json::array();
  for (const TrueObject& object : truth.objects) {
    document["objects"].push_back(format_object(object));
  }
  return format_json(document);
}

void write_truth(const std::filesystem::path& path, const SceneTruth& truth) {
  write_file_atomically(path, format_truth(truth));
}

}  // namespace symscene
