#include "moveit_output.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/number_in.hpp"
#include "gripper_choice.hpp"
#include "io/atomic_file.hpp"
#include "io/file_names.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/grasping_msgs.hpp"
#include "text_list.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

constexpr Index most_triangles = 10000;  // of all objects: 0.6 MB of JSON

void check_name(const fs::path& path, const char* flag) {
  if (!path.empty() && !is_yaml(path) && path.extension() != ".json")
    throw InputError(flag, "a name that ends in .json or .yaml", path.string());
}

/// NAME or NAME=SHARE.
FingerJoint parse_joint(const std::string& text, double usual_share) {
  const std::size_t equals = text.find('=');
  FingerJoint joint{text.substr(0, equals), usual_share};
  if (equals != std::string::npos)
    joint.share = number_in<double>(text.substr(equals + 1)).value_or(std::nan(""));
  if (joint.name.empty() || !std::isfinite(joint.share))
    throw InputError("--finger-joints", "NAME or NAME=SHARE", fmt::format("\"{}\"", text));
  return joint;
}

std::vector<FingerJoint> parse_joints(const std::string& text) {
  const std::vector<std::string> items = separated(text);
  std::vector<FingerJoint> joints;
  for (const std::string& item : items)
    joints.push_back(parse_joint(item, 1.0 / static_cast<double>(items.size())));
  return joints;
}

std::vector<std::string> classes_of(const GraspScene& scene) {
  std::vector<std::string> names;
  for (const GraspObject& object : scene.objects)
    names.emplace_back(object.symmetry_class ? to_string(object.symmetry_class->kind) : "");
  return names;
}

std::string describe(const ThinnedSurfaces& surfaces) {
  return fmt::format(
      "surfaces of objects in messages: {} triangles; 99 % of the full ones are within {:.1f} mm, "
      "all within {:.1f} mm",
      surfaces.triangles, 1e3 * std::min(surfaces.usual_error, surfaces.error),
      1e3 * surfaces.error);
}

}  // namespace

void MoveItOutput::add_to(Arguments& arguments) {
  arguments.file("--moveit", path,
                 "also write all grasps as moveit_msgs/Grasp, the objects as "
                 "moveit_msgs/CollisionObject and the motion as moveit_msgs/RobotTrajectory: .json "
                 "or .yaml");
  arguments.file("--grasping-msgs", grasping_path,
                 "also write objects with their grasps as grasping_msgs/GraspableObject: .json or "
                 ".yaml");
  arguments.text("--finger-joints", "NAMES", finger_joints,
                 "joints of the fingers in these messages, separated by commas: NAME, which stands "
                 "at an equal share of the opening, or NAME=SHARE (default: those of the robot's "
                 "description)");
  arguments.choice("--ros", ros, {"1", "2"},
                   "names of times in messages: secs, nsecs or sec, nanosec (default 2)");
}

void MoveItOutput::check() const {
  if (!is_wanted() && !finger_joints.empty())
    throw InputError("--finger-joints", "--moveit or --grasping-msgs beside it", "none");
  check_name(path, "--moveit");
  check_name(grasping_path, "--grasping-msgs");
  if (!finger_joints.empty()) parse_joints(finger_joints);
}

/// The joints in the robot's description are those of its own gripper.
std::vector<FingerJoint> MoveItOutput::joints_of(const RobotArm& arm,
                                                 const Gripper& gripper) const {
  if (!finger_joints.empty()) return parse_joints(finger_joints);
  if (has_gripper(arm, gripper) || arm.finger_joints.empty()) return arm.finger_joints;
  throw InputError("--finger-joints",
                   fmt::format("the joints of the gripper {}, as the robot's description has those "
                               "of {}",
                               gripper.name, arm.gripper.value_or("another")),
                   "none");
}

std::string MoveItOutput::write(const MoveItContent& content) const {
  std::vector<TriangleMesh> surfaces;
  for (const GraspObject& object : content.scene.objects) surfaces.push_back(object.surface.mesh);
  const ThinnedSurfaces thinned = thinned_surfaces(surfaces, most_triangles);
  const MoveItScene messages{content.robot.model.links.front().name,
                             content.robot.T_world_base.inverse(),
                             content.grasps,
                             content.gripper,
                             content.arm.T_tip_tool(content.gripper).inverse(),
                             thinned.meshes,
                             content.scene.table,
                             joints_of(content.arm, content.gripper),
                             content.trajectory ? &*content.trajectory : nullptr};
  if (!path.empty())
    write_file_atomically(path, is_yaml(path) ? format_moveit_yaml(messages, version())
                                              : format_moveit_json(messages, version()));
  if (!grasping_path.empty()) {
    const std::vector<std::string> classes = classes_of(content.scene);
    write_file_atomically(grasping_path,
                          is_yaml(grasping_path)
                              ? format_graspable_objects_yaml(messages, classes, version())
                              : format_graspable_objects_json(messages, classes, version()));
  }
  return describe(thinned);
}

}  // namespace symscene::app
