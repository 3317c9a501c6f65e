#include "objects_json.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/rejected_points.hpp"
#include "io/pose_json.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/result.hpp"

namespace symscene {
namespace {

constexpr const char* result_to_write = "result to write";
constexpr std::size_t version = 3;
constexpr std::size_t most_order = 1000;  // of an axis that is read

Json format_axes(const Eigen::Matrix3d& columns) {
  Json axes = Json::array();
  for (int k = 0; k < 3; ++k)
    axes.push_back(to_json(Eigen::Vector3d(columns.col(k)), result_to_write));
  return axes;
}

Json format_solid(const SolidProperties& solid) {
  return {{"volume", to_json(solid.volume, result_to_write)},
          {"centre_of_mass", to_json(solid.centre_of_mass, result_to_write)},
          {"principal_axes", format_axes(solid.principal_axes)},
          {"principal_moments", to_json(solid.principal_moments, result_to_write)}};
}

Json format_dimension(const Dimension& dimension) {
  Json json = {{"name", dimension.name}};
  json[dimension.sigma ? "value" : "at_least"] = to_json(dimension.value, result_to_write);
  if (dimension.sigma) json["sigma"] = to_json(*dimension.sigma, result_to_write);
  if (!dimension.reason.empty()) json["reason"] = dimension.reason;
  return json;
}

Json format_class(const ObjectClass& symmetry_class) {
  Json json = {{"name", to_string(symmetry_class.kind)},
               {"center", to_json(symmetry_class.center, result_to_write)},
               {"axes", format_axes(symmetry_class.axes)},
               {"residual", to_json(symmetry_class.residual, result_to_write)},
               {"explained", to_json(symmetry_class.explained, result_to_write)}};
  if (symmetry_class.kind == SymmetryClass::n_fold) json["order"] = symmetry_class.order;
  json["dimensions"] = Json::array();
  for (const Dimension& dimension : symmetry_class.dimensions)
    json["dimensions"].push_back(format_dimension(dimension));
  return json;
}

void add_box(const ObjectBox& box, Json& json) {
  json["T_world_object"] = pose_json(box.T_world_object, result_to_write);
  json["box"] = {{"T_world_box", pose_json(box.T_world_box, result_to_write)},
                 {"size_m", to_json(box.size, result_to_write)}};
}

/// NaN and infinity become null.
Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

void add_score_effects(const std::vector<ScoreEffect>& effects, Json& json) {
  if (effects.empty()) return;
  Json list = Json::array();
  for (const ScoreEffect& each : effects) {
    list.push_back({{"feature", each.feature},
                    {"value", number_or_null(each.value)},
                    {"median", number_or_null(each.median)},
                    {"effect", number_or_null(each.effect)}});
  }
  json["score_effects"] = std::move(list);
}

Json format_object(const SegmentationResult& result, std::size_t id) {
  const SceneObject& object = result.objects[id];
  Json json = {{"id", id}, {"points", object.points}};
  if (object.score) json["score"] = to_json(*object.score, result_to_write);
  json["confidence"] = to_json(object.confidence, result_to_write);
  add_score_effects(object.score_effects, json);
  json["rotational"] = Json::array();
  for (const ObjectAxis& axis : object.rotational) {
    json["rotational"].push_back({{"point", to_json(axis.axis.point, result_to_write)},
                                  {"direction", to_json(axis.axis.direction, result_to_write)},
                                  {"residual", to_json(axis.residual, result_to_write)}});
  }
  json["reflectional"] = Json::array();
  for (const ObjectPlane& plane : object.reflectional) {
    json["reflectional"].push_back({{"point", to_json(plane.plane.point, result_to_write)},
                                    {"normal", to_json(plane.plane.normal, result_to_write)},
                                    {"residual", to_json(plane.residual, result_to_write)}});
  }
  if (object.symmetry_class) json["class"] = format_class(*object.symmetry_class);
  if (object.centroid) json["centroid"] = to_json(*object.centroid, result_to_write);
  if (object.box) add_box(*object.box, json);
  json["cloud"] = object_cloud_name(id);
  if (has_surface(result, id)) json["surface"] = surface_name(id);
  if (object.solid) json["solid"] = format_solid(*object.solid);
  return json;
}

Json format_rejection(const Rejection& rejection) {
  Json json = {{"kind", rejection.kind},
               {"reason", rejection.reason},
               {"value", number_or_null(rejection.value)},
               {"bound", number_or_null(rejection.bound)},
               {"size", rejection.size}};
  if (!rejection.points.empty()) json["points"] = kept_points(rejection);
  add_score_effects(rejection.score_effects, json);
  return json;
}

Json format_timings(const std::vector<StageTime>& timings) {
  Json json = Json::object();
  for (const StageTime& time : timings) {
    json[time.stage] = json.value(time.stage, 0.0) + time.seconds;
  }
  return json;
}

/// What made a result, which is JSON already.
Json parsed_made_by(const std::string& made_by) {
  return made_by.empty() ? Json() : parse_json(made_by, result_to_write);
}

/// Version 1 called residuals scores.
const char* residual_name(std::size_t file_version) {
  return file_version == 1 ? "score" : "residual";
}

ObjectAxis parse_axis(const JsonCursor& axis, std::size_t file_version) {
  return {{axis.at("point").vector3(), axis.at("direction").direction()},
          axis.at(residual_name(file_version)).number()};
}

ObjectPlane parse_plane(const JsonCursor& plane, std::size_t file_version) {
  return {{plane.at("point").vector3(), plane.at("normal").direction()},
          plane.at(residual_name(file_version)).number()};
}

double share(const JsonCursor& value, const char* expected) {
  const double number = value.number();
  if (!(number >= 0.0 && number <= 1.0)) value.fail(expected);
  return number;
}

Eigen::Matrix3d parse_axes(const JsonCursor& json) {
  Eigen::Matrix3d columns;
  const std::vector<JsonCursor> axes = json.items(3);
  for (int k = 0; k < 3; ++k) columns.col(k) = axes[static_cast<std::size_t>(k)].vector3();
  return columns;
}

Dimension parse_dimension(const JsonCursor& json) {
  Dimension dimension;
  dimension.name = json.at("name").string();
  const auto sigma = json.find("sigma");
  if (sigma) dimension.sigma = sigma->number();
  dimension.value = json.at(sigma ? "value" : "at_least").number();
  if (const auto reason = json.find("reason")) dimension.reason = reason->string();
  return dimension;
}

ObjectClass parse_class(const JsonCursor& json) {
  const std::optional<SymmetryClass> kind = symmetry_class_of(json.at("name").string());
  if (!kind) json.at("name").fail("the name of a symmetry class");
  ObjectClass symmetry_class;
  symmetry_class.kind = *kind;
  symmetry_class.center = json.at("center").vector3();
  symmetry_class.axes = parse_axes(json.at("axes"));
  symmetry_class.residual = json.at("residual").number();
  symmetry_class.explained = share(json.at("explained"), "a share in [0, 1]");
  if (symmetry_class.kind == SymmetryClass::n_fold) {
    const std::size_t order = json.at("order").count();
    if (order < 2 || order > most_order) json.at("order").fail("an order of 2 to 1000");
    symmetry_class.order = static_cast<int>(order);
  }
  for (const JsonCursor& dimension : json.at("dimensions").items())
    symmetry_class.dimensions.push_back(parse_dimension(dimension));
  return symmetry_class;
}

ObjectBox parse_box(const JsonCursor& object, const JsonCursor& box) {
  ObjectBox result{object_pose_of(object.at("T_world_object")),
                   object_pose_of(box.at("T_world_box")), box.at("size_m").vector3()};
  if (!(result.size.minCoeff() >= 0.0)) box.at("size_m").fail("three edges of at least 0 m");
  return result;
}

SolidProperties parse_solid(const JsonCursor& json) {
  SolidProperties solid;
  solid.volume = json.at("volume").number();
  if (solid.volume < 0.0) json.at("volume").fail("a volume of at least 0 m3");
  solid.centre_of_mass = json.at("centre_of_mass").vector3();
  solid.principal_axes = parse_axes(json.at("principal_axes"));
  solid.principal_moments = json.at("principal_moments").vector3();
  return solid;
}

std::vector<ScoreEffect> parse_score_effects(const JsonCursor& json) {
  std::vector<ScoreEffect> effects;
  const auto list = json.find("score_effects");
  if (!list) return effects;
  for (const JsonCursor& each : list->items())
    effects.push_back({each.at("feature").string(), each.at("value").number_or_nan(),
                       each.at("median").number_or_nan(), each.at("effect").number_or_nan()});
  return effects;
}

SceneObject parse_object(const JsonCursor& object, std::size_t id, Index cloud_size,
                         std::size_t file_version) {
  if (object.at("id").count() != id) object.at("id").fail(std::to_string(id));
  SceneObject result;
  result.points = object.at("points").indices(cloud_size);
  if (const auto score = object.find("score")) result.score = share(*score, "a score in [0, 1]");
  if (file_version > 1)
    result.confidence = share(object.at("confidence"), "a confidence in [0, 1]");
  result.score_effects = parse_score_effects(object);
  for (const JsonCursor& axis : object.at("rotational").items())
    result.rotational.push_back(parse_axis(axis, file_version));
  for (const JsonCursor& plane : object.at("reflectional").items())
    result.reflectional.push_back(parse_plane(plane, file_version));
  if (const auto found = object.find("class")) result.symmetry_class = parse_class(*found);
  if (const auto centroid = object.find("centroid")) result.centroid = centroid->vector3();
  if (const auto box = object.find("box")) result.box = parse_box(object, *box);
  // Versions 1 and 2 called the cloud of an object its mesh.
  const auto cloud = object.find(file_version < 3 ? "mesh" : "cloud");
  if (cloud && cloud->string() != object_cloud_name(id)) cloud->fail(object_cloud_name(id));
  if (const auto surface = object.find("surface"); surface && surface->string() != surface_name(id))
    surface->fail(surface_name(id));
  if (const auto solid = object.find("solid")) result.solid = parse_solid(*solid);
  return result;
}

Rejection parse_rejection(const JsonCursor& rejection, Index cloud_size) {
  Rejection result{rejection.at("kind").string(), rejection.at("reason").string(),
                   rejection.at("value").number_or_nan(), rejection.at("bound").number_or_nan(),
                   rejection.at("size").count()};
  if (const auto points = rejection.find("points")) result.points = points->indices(cloud_size);
  result.score_effects = parse_score_effects(rejection);
  return result;
}

void parse_records(const JsonCursor& root, Index cloud_size, SegmentationResult& result) {
  if (const auto rejected = root.find("rejected")) {
    for (const JsonCursor& item : rejected->items()) {
      result.rejected.push_back(parse_rejection(item, cloud_size));
    }
  }
  if (const auto funnel = root.find("funnel")) {
    for (const JsonCursor& step : funnel->items()) {
      result.funnel.push_back({step.at("step").string(), step.at("count").count()});
    }
  }
  if (const auto warnings = root.find("warnings")) {
    for (const JsonCursor& warning : warnings->items()) {
      result.warnings.push_back(warning.string());
    }
  }
  if (const auto timings = root.find("timings")) {
    for (const auto& [stage, seconds] : timings->members()) {
      result.timings.push_back({stage, seconds.number()});
    }
  }
}

}  // namespace

std::string object_cloud_name(std::size_t id) { return fmt::format("objects/{}.ply", id); }
std::string surface_name(std::size_t id) { return fmt::format("objects/{}.obj", id); }

bool has_surface(const SegmentationResult& result, std::size_t id) {
  return id < result.surfaces.size() && result.surfaces[id].mesh.triangles.rows() != 0;
}

std::string format_objects_json(const SegmentationResult& result, bool with_timings,
                                const std::string& made_by) {
  Json document = {{"version", version}, {"cloud", "cloud.ply"}};
  if (Json made = parsed_made_by(made_by); !made.is_null()) document["made_by"] = std::move(made);
  if (result.table) document["table"] = to_json(*result.table, result_to_write);
  document["objects"] = Json::array();
  for (std::size_t id = 0; id < result.objects.size(); ++id)
    document["objects"].push_back(format_object(result, id));
  document["rejected"] = Json::array();
  for (const Rejection& rejection : result.rejected) {
    document["rejected"].push_back(format_rejection(rejection));
  }
  document["funnel"] = Json::array();
  for (const FunnelStep& step : result.funnel) {
    document["funnel"].push_back({{"step", step.step}, {"count", step.count}});
  }
  if (!result.warnings.empty()) document["warnings"] = result.warnings;
  if (with_timings) document["timings"] = format_timings(result.timings);
  return format_json(document);
}

ParsedObjects parse_objects(std::string_view text, const std::string& name, Index cloud_size) {
  const Json document = parse_json(text, name);
  const JsonCursor root(document, name);
  const std::size_t file_version = root.at("version").count();
  if (file_version < 1 || file_version > version)
    root.at("version").fail(fmt::format("at most {}", version));
  if (root.at("cloud").string() != "cloud.ply") root.at("cloud").fail("\"cloud.ply\"");
  ParsedObjects parsed;
  SegmentationResult& result = parsed.result;
  if (const auto table = root.find("table")) result.table = table->plane();
  for (const JsonCursor& object : root.at("objects").items()) {
    result.objects.push_back(parse_object(object, result.objects.size(), cloud_size, file_version));
    parsed.names_surface.push_back(object.find("surface") ? 1 : 0);
  }
  parse_records(root, cloud_size, result);
  return parsed;
}

SegmentationResult parse_objects_json(std::string_view text, const std::string& name,
                                      Index cloud_size) {
  return parse_objects(text, name, cloud_size).result;
}

}  // namespace symscene
