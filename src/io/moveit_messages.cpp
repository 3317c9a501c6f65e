#include "moveit_messages.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/retreat.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

constexpr const char* moveit_to_write = "grasps for MoveIt to write";
constexpr double table_thickness = 0.05;  // of the box [m]
constexpr std::int64_t box_type = 1;      // shape_msgs/SolidPrimitive.BOX
constexpr double vertex_step = 1e-5;      // that vertices are rounded to, for short files [m]

}  // namespace

std::string message_name(int object) { return fmt::format("object_{}", object); }

MoveItMessages::MoveItMessages(const MoveItScene& scene, RosVersion version)
    : scene_(scene), ros_(version, moveit_to_write) {}

Json MoveItMessages::posture(double opening) const {
  JointTrajectory trajectory;
  for (const FingerJoint& joint : scene_.finger_joints)
    trajectory.joint_names.push_back(joint.name);
  if (scene_.finger_joints.empty()) return ros_.joint_trajectory(trajectory);
  Eigen::VectorXd positions(static_cast<Eigen::Index>(scene_.finger_joints.size()));
  for (Eigen::Index k = 0; k < positions.size(); ++k)
    positions[k] = opening * scene_.finger_joints[static_cast<std::size_t>(k)].share;
  trajectory.points.push_back({0.0, positions, {}, {}});
  return ros_.joint_trajectory(trajectory);
}

/// Along a direction of the world. A shorter way than the fingers are long does not clear them.
Json MoveItMessages::translation(const Eigen::Vector3d& direction_world, double distance) const {
  return {{"direction",
           {{"header", ros_.header(scene_.frame)},
            {"vector", ros_.vector(scene_.T_frame_world.linear() * direction_world)}}},
          {"desired_distance", ros_.number(distance)},
          {"min_distance", ros_.number(std::min(distance, scene_.gripper.finger_depth))}};
}

Eigen::Vector3d MoveItMessages::retreat_direction(const Eigen::Vector3d& approach) const {
  if (retreats_backwards(approach, scene_.table)) return -approach;
  return scene_.table->normal;
}

Json MoveItMessages::grasp(std::size_t id) const {
  const Grasp& grasp = scene_.grasps[id];
  const Eigen::Vector3d approach = grasp.T_world_tool.linear().col(2);
  const Gripper& gripper = scene_.gripper;
  return {
      {"id", fmt::format("grasp_{}", id)},
      {"pre_grasp_posture", posture(gripper.max_opening)},
      {"grasp_posture", posture(grasp.opening)},
      {"grasp_pose",
       {{"header", ros_.header(scene_.frame)},
        {"pose", ros_.pose(scene_.T_frame_world * grasp.T_world_tool * scene_.T_tool_link)}}},
      {"grasp_quality", ros_.number(grasp.quality)},
      {"pre_grasp_approach", translation(approach, gripper.approach_distance)},
      {"post_grasp_retreat", translation(retreat_direction(approach), gripper.retreat_distance)},
      {"post_place_retreat", translation(-approach, gripper.approach_distance)},
      {"max_contact_force", ros_.number(gripper.force)},
      {"allowed_touch_objects", Json::array({message_name(grasp.object)})}};
}

Json MoveItMessages::mesh(const TriangleMesh& surface) const {
  Json vertices = Json::array();
  for (Eigen::Index i = 0; i < surface.vertices.rows(); ++i) {
    const Eigen::Vector3d vertex =
        scene_.T_frame_world * surface.vertices.row(i).transpose().cast<double>();
    const double steps = std::round(1.0 / vertex_step);
    vertices.push_back(ros_.vector((vertex.array() * steps).round() / steps));
  }
  Json triangles = Json::array();
  for (Eigen::Index i = 0; i < surface.triangles.rows(); ++i) {
    const auto t = surface.triangles.row(i);
    triangles.push_back({{"vertex_indices", Json::array({t[0], t[1], t[2]})}});
  }
  return {{"triangles", triangles}, {"vertices", vertices}};
}

/// z along the table's normal, origin on it.
Eigen::Isometry3d MoveItMessages::T_world_table() const {
  const Plane& table = *scene_.table;
  Eigen::Isometry3d T(Eigen::Translation3d(-table.offset * table.normal));
  T.linear() = shortest_rotation(Eigen::Vector3d::UnitZ(), table.normal);
  return T;
}

/// The box of all surfaces in the frame of the table; none without a table or a surface.
std::optional<Eigen::AlignedBox3d> MoveItMessages::bounds_on_table() const {
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
std::optional<MoveItMessages::Box> MoveItMessages::table_box() const {
  const auto bounds = bounds_on_table();
  if (!bounds) return std::nullopt;
  const double margin = scene_.gripper.approach_distance + scene_.gripper.finger_depth +
                        scene_.gripper.palm_size.maxCoeff();
  const Eigen::Vector3d center = bounds->center(), size = bounds->sizes();
  const Eigen::Isometry3d T_world_box =
      T_world_table() * Eigen::Translation3d(center.x(), center.y(), -0.5 * table_thickness);
  return Box{{{"type", box_type},
              {"dimensions", Json::array({ros_.number(size.x() + 2.0 * margin),
                                          ros_.number(size.y() + 2.0 * margin), table_thickness})}},
             ros_.pose(scene_.T_frame_world * T_world_box)};
}

Json MoveItMessages::table_plane() const {
  const Eigen::Isometry3d T_frame_table = scene_.T_frame_world * T_world_table();
  const Eigen::Vector3d normal = T_frame_table.linear().col(2);
  const double offset = -normal.dot(T_frame_table.translation());
  return {{"coef", Json::array({ros_.number(normal.x()), ros_.number(normal.y()),
                                ros_.number(normal.z()), ros_.number(offset)})}};
}

Json MoveItMessages::robot_trajectory(const JointTrajectory& trajectory) const {
  return {
      {"joint_trajectory", ros_.joint_trajectory(trajectory)},
      {"multi_dof_joint_trajectory",
       {{"header", ros_.header("")}, {"joint_names", Json::array()}, {"points", Json::array()}}}};
}

}  // namespace symscene
