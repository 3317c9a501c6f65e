#include "symscene/io/moveit.hpp"

#include "moveit_messages.hpp"
#include "yaml_text.hpp"

namespace symscene {
namespace {

/// Without `operation`, whose default is ADD: a byte has no common form in JSON and YAML.
Json collision_object(const MoveItMessages& messages, const std::string& id) {
  return {{"header", messages.ros().header(messages.scene().frame)}, {"id", id}};
}

Json collision_objects(const MoveItMessages& messages) {
  const std::span<const TriangleMesh> surfaces = messages.scene().surfaces;
  Json objects = Json::array();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i].triangles.rows() == 0) continue;
    Json object = collision_object(messages, message_name(static_cast<int>(i)));
    object["meshes"] = Json::array({messages.mesh(surfaces[i])});
    object["mesh_poses"] = Json::array({messages.ros().pose(Eigen::Isometry3d::Identity())});
    objects.push_back(std::move(object));
  }
  if (const auto box = messages.table_box()) {
    Json table = collision_object(messages, "table");
    table["primitives"] = Json::array({box->primitive});
    table["primitive_poses"] = Json::array({box->pose});
    objects.push_back(std::move(table));
  }
  return objects;
}

Json moveit_document(const MoveItScene& scene, RosVersion version) {
  const MoveItMessages messages(scene, version);
  Json grasps = Json::array();
  for (std::size_t i = 0; i < scene.grasps.size(); ++i) grasps.push_back(messages.grasp(i));
  Json json = {{"grasps", grasps}, {"collision_objects", collision_objects(messages)}};
  if (scene.trajectory != nullptr)
    json["robot_trajectory"] = messages.robot_trajectory(*scene.trajectory);
  return json;
}

}  // namespace

std::string format_moveit_json(const MoveItScene& scene, RosVersion version) {
  return format_json(moveit_document(scene, version));
}

std::string format_moveit_yaml(const MoveItScene& scene, RosVersion version) {
  return format_yaml(moveit_document(scene, version));
}

}  // namespace symscene
