#include "symmetry_formats.hpp"

#include <algorithm>

namespace symscene::app {
namespace {

using Json = nlohmann::ordered_json;

Json coordinates(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// 4×4 by rows.
Json matrix(const Eigen::Isometry3d& motion, double scale) {
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      rows.push_back(motion(row, column) * (row < 3 && column == 3 ? scale : 1.0));
  }
  return rows;
}

double percent(double residual, const ModelSymmetries& model) {
  return 100.0 * residual / model.group.diagonal;
}

Json axis_json(const GroupAxis& found, const ModelSymmetries& model) {
  const bool turns_freely = found.order == GroupAxis::continuous;
  return {{"point", coordinates(found.axis.point)},
          {"direction", coordinates(found.axis.direction)},
          {"order", turns_freely ? Json("continuous") : Json(found.order)},
          {"residual_mm", model.millimetres * found.residual},
          {"residual_percent", percent(found.residual, model)}};
}

Json plane_json(const GroupPlane& found, const ModelSymmetries& model) {
  return {{"point", coordinates(found.plane.point)},
          {"normal", coordinates(found.plane.normal)},
          {"residual_mm", model.millimetres * found.residual},
          {"residual_percent", percent(found.residual, model)}};
}

/// Whether JSON fits on a line: a value, or a list of values.
bool is_flat(const Json& json) {
  return json.is_primitive() || json.empty() ||
         (json.is_array() && std::all_of(json.begin(), json.end(),
                                         [](const Json& item) { return item.is_primitive(); }));
}

void append_json(const Json& json, const std::string& indent, std::string& text) {
  if (is_flat(json)) {
    text += json.dump();
    return;
  }
  const std::string inner = indent + "  ";
  const char* separator = "\n";
  text += json.is_object() ? "{" : "[";
  for (const auto& [key, value] : json.items()) {
    text += separator + inner;
    if (json.is_object()) text += Json(key).dump() + ": ";
    append_json(value, inner, text);
    separator = ",\n";
  }
  text += "\n" + indent + (json.is_object() ? "}" : "]");
}

/// As JSON, but numbers with an exponent have a point: parsers of YAML 1.1 read others as text.
std::string yaml_value(const Json& json) {
  std::string text;
  if (json.is_array()) {
    for (const Json& item : json) text += (text.empty() ? "" : ", ") + yaml_value(item);
    return "[" + text + "]";
  }
  text = json.dump();
  const std::size_t exponent = text.find('e');
  if (json.is_number_float() && exponent != std::string::npos && text.find('.') > exponent)
    text.insert(exponent, ".0");
  return text;
}

/// Keys are plain words. `text` ends where the first line begins: members of a list begin behind
/// its dash.
void append_yaml(const Json& json, const std::string& indent, std::string& text) {
  bool follows = false;
  for (const auto& [key, value] : json.items()) {
    if (follows) text += indent;
    follows = true;
    text += json.is_object() ? key + ":" : "-";
    if (is_flat(value)) {
      text += " " + yaml_value(value) + "\n";
    } else {
      text += json.is_object() ? "\n" + indent + "  " : " ";
      append_yaml(value, indent + "  ", text);
    }
  }
}

Json continuous_json(const Eigen::Vector3d& direction, const Eigen::Vector3d& point, double scale) {
  return {{"axis", coordinates(direction)}, {"offset", coordinates(scale * point)}};
}

Json continuous_symmetries(const SymmetryGroup& group, double millimetres) {
  Json list = Json::array();
  if (group.sphere) {
    for (const Eigen::Vector3d& direction :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)})
      list.push_back(continuous_json(direction, group.center, millimetres));
  }
  for (const GroupAxis& found : group.axes) {
    if (found.order == GroupAxis::continuous)
      list.push_back(continuous_json(found.axis.direction, found.axis.point, millimetres));
  }
  return list;
}

}  // namespace

Json group_json(const ModelSymmetries& model) {
  const SymmetryGroup& group = model.group;
  Json json = {{"name", model.name},
               {"diameter", model.diameter},
               {"diagonal", group.diagonal},
               {"center", coordinates(group.center)},
               {"sphere", group.sphere}};
  if (group.sphere) json["sphere_residual_mm"] = model.millimetres * group.sphere_residual;
  json["axes"] = Json::array();
  for (const GroupAxis& found : group.axes) json["axes"].push_back(axis_json(found, model));
  json["planes"] = Json::array();
  for (const GroupPlane& found : group.planes) json["planes"].push_back(plane_json(found, model));
  json["rotations"] = Json::array();
  for (const Eigen::Isometry3d& rotation : group.rotations)
    json["rotations"].push_back(matrix(rotation, 1.0));
  return json;
}

Json partial_json(const std::string& name, const ObjectSymmetries& found) {
  Json json = {{"name", name},
               {"center", coordinates(found.centroid)},
               {"sphere", found.sphere},
               {"axes", Json::array()},
               {"planes", Json::array()}};
  for (const ObjectAxis& axis : found.rotational)
    json["axes"].push_back({{"point", coordinates(axis.axis.point)},
                            {"direction", coordinates(axis.axis.direction)},
                            {"order", "continuous"},
                            {"residual", axis.residual}});
  for (const ObjectPlane& plane : found.reflectional)
    json["planes"].push_back({{"point", coordinates(plane.plane.point)},
                              {"normal", coordinates(plane.plane.normal)},
                              {"residual", plane.residual}});
  return json;
}

Json bop_json(const ModelSymmetries& model) {
  const double scale = model.millimetres;
  const Eigen::Vector3d low = scale * model.box.min.cast<double>();
  const Eigen::Vector3d size = scale * model.box.extent().cast<double>();
  Json json = {{"diameter", scale * model.diameter},
               {"min_x", low.x()},
               {"min_y", low.y()},
               {"min_z", low.z()},
               {"size_x", size.x()},
               {"size_y", size.y()},
               {"size_z", size.z()}};
  Json discrete = Json::array();
  for (const Eigen::Isometry3d& rotation : model.group.rotations)
    discrete.push_back(matrix(rotation, scale));
  if (!discrete.empty()) json["symmetries_discrete"] = std::move(discrete);
  Json continuous = continuous_symmetries(model.group, scale);
  if (!continuous.empty()) json["symmetries_continuous"] = std::move(continuous);
  return json;
}

std::string format_json(const Json& json) {
  std::string text;
  append_json(json, "", text);
  return text + "\n";
}

std::string format_yaml(const Json& json) {
  std::string text;
  append_yaml(json, "", text);
  return text;
}

}  // namespace symscene::app
