#include "symscene/ground_truth/truth_file.hpp"

#include <algorithm>

#include "io/atomic_file.hpp"
#include "io/json_cursor.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/mesh.hpp"

namespace symscene {
namespace {

constexpr const char* truth_to_write = "ground truth to write";

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

/// A rigid 4×4 matrix, by rows.
Eigen::Isometry3d parse_pose(const JsonCursor& pose) {
  constexpr double tolerance = 1e-3;
  Eigen::Matrix4d matrix;
  const std::vector<JsonCursor> rows = pose.items(4);
  for (int i = 0; i < 4; ++i) {
    const std::vector<JsonCursor> numbers = rows[static_cast<std::size_t>(i)].items(4);
    for (int k = 0; k < 4; ++k) matrix(i, k) = numbers[static_cast<std::size_t>(k)].number();
  }
  const Eigen::Matrix3d turn = matrix.topLeftCorner<3, 3>();
  if (!(turn * turn.transpose()).isIdentity(tolerance) || turn.determinant() < 0.0 ||
      matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    pose.fail("a rotation and translation as a 4x4 matrix");
  }
  return Eigen::Isometry3d(matrix);
}

Json format_pose(const Eigen::Isometry3d& pose) {
  Json rows = Json::array();
  for (int i = 0; i < 4; ++i) {
    Json row = Json::array();
    for (int k = 0; k < 4; ++k) row.push_back(to_json(pose.matrix()(i, k), truth_to_write));
    rows.push_back(std::move(row));
  }
  return rows;
}

void parse_symmetries(const JsonCursor& object, TrueObject& result) {
  if (const auto axes = object.find("rot")) {
    for (const JsonCursor& axis : axes->items()) result.rotational.push_back(parse_axis(axis));
  }
  if (const auto planes = object.find("refl")) {
    for (const JsonCursor& plane : planes->items())
      result.reflectional.push_back(parse_plane(plane));
  }
  if (const auto sphere = object.find("sphere")) result.sphere = sphere->boolean();
  result.centroid = object.at("centroid").vector3();
}

TrueObject parse_object(const JsonCursor& object, std::optional<Index> cloud_size) {
  TrueObject result;
  if (const auto mesh = object.find("mesh")) result.name = result.mesh = mesh->string();
  if (const auto name = object.find("name")) result.name = name->string();
  if (const auto pose = object.find("pose")) result.T_world_mesh = parse_pose(*pose);
  if (const auto points = object.find("points")) {
    result.points = points->indices(cloud_size);
  } else if (result.mesh.empty() || !result.T_world_mesh) {
    object.fail("\"points\", or \"mesh\" and \"pose\"");
  }
  parse_symmetries(object, result);
  return result;
}

Json format_object(const TrueObject& object) {
  Json json = {{"name", object.name}};
  const bool has_model = !object.mesh.empty() && object.T_world_mesh.has_value();
  if (!object.mesh.empty()) json["mesh"] = object.mesh;
  if (object.T_world_mesh) json["pose"] = format_pose(*object.T_world_mesh);
  if (!object.points.empty() || !has_model) json["points"] = object.points;
  json["rot"] = Json::array();
  for (const TrueAxis& axis : object.rotational) {
    json["rot"].push_back({{"p", to_json(axis.axis.point, truth_to_write)},
                           {"d", to_json(axis.axis.direction, truth_to_write)},
                           {"strict", axis.strict}});
  }
  json["refl"] = Json::array();
  for (const TruePlane& plane : object.reflectional) {
    json["refl"].push_back({{"p", to_json(plane.plane.point, truth_to_write)},
                            {"n", to_json(plane.plane.normal, truth_to_write)},
                            {"strict", plane.strict}});
  }
  json["sphere"] = object.sphere;
  json["centroid"] = to_json(object.centroid, truth_to_write);
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
  document["table"] = to_json(truth.table, truth_to_write);
  document["objects"] = Json::array();
  for (const TrueObject& object : truth.objects) {
    document["objects"].push_back(format_object(object));
  }
  return format_json(document);
}

std::vector<TriangleMesh> read_truth_meshes(const std::filesystem::path& dir,
                                            const SceneTruth& truth) {
  std::vector<TriangleMesh> meshes;
  for (const TrueObject& object : truth.objects) {
    const std::filesystem::path name = object.mesh;
    if (name.empty() || name != name.filename())
      throw InputError(dir.string(), "ground truth that names each object's mesh", object.mesh);
    meshes.push_back(read_mesh(dir / "meshes" / (object.mesh + ".ply")));
  }
  return meshes;
}

std::vector<TrueObject> read_model_symmetries(const std::filesystem::path& path) {
  const Json document = parse_json(read_file(path), path.string());
  const std::string name = path.string();
  std::vector<TrueObject> models;
  for (const auto& [model, symmetries] : JsonCursor(document, name).members()) {
    models.emplace_back();
    parse_symmetries(symmetries, models.back());
    models.back().name = model;
  }
  return models;
}

}  // namespace symscene
