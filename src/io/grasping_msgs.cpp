#include "symscene/io/grasping_msgs.hpp"

#include "moveit_messages.hpp"
#include "yaml_text.hpp"

namespace symscene {
namespace {

constexpr const char* table_name = "table";

/// Without `point_cluster`: its bytes have no common form in JSON and YAML. Without `surface`,
/// whose default is no plane, except for the table.
Json object_message(const MoveItMessages& messages, const std::string& name) {
  return {{"header", messages.ros().header(messages.scene().frame)}, {"name", name}};
}

Json graspable_object(const MoveItMessages& messages, std::size_t index,
                      const std::string& symmetry_class) {
  const MoveItScene& scene = messages.scene();
  Json object = object_message(messages, message_name(static_cast<int>(index)));
  if (scene.table) object["support_surface"] = table_name;
  if (!symmetry_class.empty())
    object["properties"] = Json::array({{{"name", "class"}, {"value", symmetry_class}}});
  object["meshes"] = Json::array();
  object["mesh_poses"] = Json::array();
  if (scene.surfaces[index].triangles.rows() > 0) {
    object["meshes"].push_back(messages.mesh(scene.surfaces[index]));
    object["mesh_poses"].push_back(messages.ros().pose(Eigen::Isometry3d::Identity()));
  }
  Json grasps = Json::array();
  for (std::size_t i = 0; i < scene.grasps.size(); ++i) {
    if (scene.grasps[i].object == static_cast<int>(index)) grasps.push_back(messages.grasp(i));
  }
  return {{"object", std::move(object)}, {"grasps", std::move(grasps)}};
}

Json support_surfaces(const MoveItMessages& messages) {
  Json list = Json::array();
  if (!messages.scene().table) return list;
  Json table = object_message(messages, table_name);
  if (const auto box = messages.table_box()) {
    table["primitives"] = Json::array({box->primitive});
    table["primitive_poses"] = Json::array({box->pose});
  }
  table["surface"] = messages.table_plane();
  list.push_back(std::move(table));
  return list;
}

Json graspable_document(const MoveItScene& scene, std::span<const std::string> classes,
                        RosVersion version) {
  const MoveItMessages messages(scene, version);
  Json objects = Json::array();
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    objects.push_back(graspable_object(messages, i, i < classes.size() ? classes[i] : ""));
  return {{"objects", std::move(objects)}, {"support_surfaces", support_surfaces(messages)}};
}

}  // namespace

std::string format_graspable_objects_json(const MoveItScene& scene,
                                          std::span<const std::string> classes,
                                          RosVersion version) {
  return format_json(graspable_document(scene, classes, version));
}

std::string format_graspable_objects_yaml(const MoveItScene& scene,
                                          std::span<const std::string> classes,
                                          RosVersion version) {
  return format_yaml(graspable_document(scene, classes, version));
}

}  // namespace symscene
