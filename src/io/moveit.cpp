#include "symscene/io/moveit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ros_json.hpp"
#include "yaml_text.hpp"

namespace symscene {
namespace {

constexpr const char* moveit_to_write = "grasps for MoveIt to write";
constexpr double table_thickness = 0.05;  // of the box [m]
constexpr std::int64_t box_type = 1;      // shape_msgs/SolidPrimitive.BOX

std::string name_of(int object) { return fmt::format("object_{}", object); }

class MoveItMessages {
 public:
  MoveItMessages(const MoveItScene& scene, RosVersion version)
      : scene_(scene), ros_(version, moveit_to_write) {}

  Json document() const {
    Json grasps = Json::array();
    for (std::size_t i = 0; i < scene_.grasps.size(); ++i)
      grasps.push_back(grasp(i, scene_.grasps[i]));
    Json objects = Json::array();
    for (std::size_t i = 0; i < scene_.surfaces.size(); ++i) {
      if (scene_.surfaces[i].triangles.rows() > 0)
        objects.push_back(object(static_cast<int>(i), scene_.surfaces[i]));
    }
    if (const auto bounds = bounds_on_table()) objects.push_back(table(*bounds));
    return {{"grasps", grasps}, {"collision_objects", objects}};
  }

 private:
  /// The shares of an opening that the joints of the fingers take.
  Json posture(double opening) const {
    JointTrajectory trajectory{scene_.finger_joints, {}};
    const auto joints = static_cast<Eigen::Index>(scene_.finger_joints.size());
    if (joints == 0) return ros_.joint_trajectory(trajectory);
    const double share = opening / static_cast<double>(joints);
    trajectory.points.push_back({0.0, Eigen::VectorXd::Constant(joints, share), {}, {}});
    return ros_.joint_trajectory(trajectory);
  }

  /// Along a direction of the world. A shorter way than the fingers are long does not clear them.
  Json translation(const Eigen::Vector3d& direction_world, double distance) const {
    return {{"direction",
             {{"header", ros_.header(scene_.frame)},
              {"vector", ros_.vector(scene_.T_frame_world.linear() * direction_world)}}},
            {"desired_distance", ros_.number(distance)},
            {"min_distance", ros_.number(std::min(distance, scene_.gripper.finger_depth))}};
  }

  Eigen::Vector3d up() const {
    return scene_.table ? scene_.table->normal : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  }

  Json grasp(std::size_t id, const Grasp& grasp) const {
    const Eigen::Vector3d approach = grasp.T_world_tool.linear().col(2);
    const bool is_steep = angle_between(approach, -up()) <= backwards_tilt;
    const Gripper& gripper = scene_.gripper;
    return {{"id", fmt::format("grasp_{}", id)},
            {"pre_grasp_posture", posture(gripper.max_opening)},
            {"grasp_posture", posture(grasp.opening)},
            {"grasp_pose",
             {{"header", ros_.header(scene_.frame)},
              {"pose", ros_.pose(scene_.T_frame_world * grasp.T_world_tool * scene_.T_tool_link)}}},
            {"grasp_quality", ros_.number(grasp.quality)},
            {"pre_grasp_approach", translation(approach, gripper.approach_distance)},
            {"post_grasp_retreat",
             translation(is_steep ? Eigen::Vector3d(-approach) : up(), gripper.retreat_distance)},
            {"post_place_retreat", translation(-approach, gripper.approach_distance)},
            {"max_contact_force", ros_.number(gripper.force)},
            {"allowed_touch_objects", Json::array({name_of(grasp.object)})}};
  }

  /// Without `operation`, whose default is ADD: a byte has no common form in JSON and YAML.
  Json collision_object(const std::string& id) const {
    return {{"header", ros_.header(scene_.frame)}, {"id", id}};
  }

  Json object(int index, const TriangleMesh& surface) const {
    Json vertices = Json::array();
    for (Eigen::Index i = 0; i < surface.vertices.rows(); ++i) {
      const Eigen::Vector3d vertex = surface.vertices.row(i).transpose().cast<double>();
      vertices.push_back(ros_.vector(scene_.T_frame_world * vertex));
    }
    Json triangles = Json::array();
    for (Eigen::Index i = 0; i < surface.triangles.rows(); ++i) {
      const auto t = surface.triangles.row(i);
      triangles.push_back({{"vertex_indices", Json::array({t[0], t[1], t[2]})}});
    }
    Json json = collision_object(name_of(index));
    json["meshes"] = Json::array({{{"triangles", triangles}, {"vertices", vertices}}});
    json["mesh_poses"] = Json::array({ros_.pose(Eigen::Isometry3d::Identity())});
    return json;
  }

  /// z along the table's normal, origin on it.
  Eigen::Isometry3d T_world_table() const {
    const Plane& table = *scene_.table;
    Eigen::Isometry3d T(Eigen::Translation3d(-table.offset * table.normal));
    T.linear() =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), table.normal).matrix();
    return T;
  }

  /// The box of all surfaces in the frame of the table; none without a table or a surface.
  std::optional<Eigen::AlignedBox3d> bounds_on_table() const {
    if (!scene_.table) return std::nullopt;
    const Eigen::Isometry3d T_table_world = T_world_table().inverse();
    Eigen::AlignedBox3d bounds;
    for (const TriangleMesh& surface : scene_.surfaces) {
      for (Eigen::Index i = 0; i < surface.vertices.rows(); ++i)
        bounds.extend(T_table_world * surface.vertices.row(i).transpose().cast<double>());
    }
    return bounds.isEmpty() ? std::nullopt : std::optional(bounds);
  }

  /// As much wider than the objects as the hand can reach beside them.
  Json table(const Eigen::AlignedBox3d& bounds) const {
    const double margin = scene_.gripper.approach_distance + scene_.gripper.finger_depth +
                          scene_.gripper.palm_size.maxCoeff();
    const Eigen::Vector3d center = bounds.center(), size = bounds.sizes();
    const Eigen::Isometry3d T_world_box =
        T_world_table() * Eigen::Translation3d(center.x(), center.y(), -0.5 * table_thickness);
    Json json = collision_object("table");
    json["primitives"] = Json::array(
        {{{"type", box_type},
          {"dimensions", Json::array({ros_.number(size.x() + 2.0 * margin),
                                      ros_.number(size.y() + 2.0 * margin), table_thickness})}}});
    json["primitive_poses"] = Json::array({ros_.pose(scene_.T_frame_world * T_world_box)});
    return json;
  }

  const MoveItScene& scene_;
  RosJson ros_;
};

}  // namespace

std::string format_moveit_json(const MoveItScene& scene, RosVersion version) {
  return format_json(MoveItMessages(scene, version).document());
}

std::string format_moveit_yaml(const MoveItScene& scene, RosVersion version) {
  return format_yaml(MoveItMessages(scene, version).document());
}

}  // namespace symscene
