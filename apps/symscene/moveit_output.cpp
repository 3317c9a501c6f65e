#include "moveit_output.hpp"

#include "io/atomic_file.hpp"
#include "io/file_names.hpp"
#include "symscene/core/error.hpp"
#include "text_list.hpp"

namespace symscene::app {
void MoveItOutput::add_to(Arguments& arguments) {
  arguments.file("--moveit", path,
                 "also write all grasps as moveit_msgs/Grasp and the objects as "
                 "moveit_msgs/CollisionObject: .json or .yaml");
  arguments.text(
      "--finger-joints", finger_joints,
      "names of the joints of the fingers, separated by commas: the postures of --moveit "
      "open each by an equal share of the opening");
  arguments.choice("--ros", ros, {"1", "2"},
                   "names of times in messages: secs, nsecs or sec, nanosec (default 2)");
}

void MoveItOutput::check() const {
  if (path.empty() && !finger_joints.empty())
    throw InputError("--finger-joints", "--moveit beside it", "none");
  if (!path.empty() && !is_yaml(path) && path.extension() != ".json")
    throw InputError("--moveit", "a name that ends in .json or .yaml", path.string());
}

void MoveItOutput::write(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                         const GraspScene& scene, const std::vector<Grasp>& grasps) const {
  if (path.empty()) return;
  std::vector<TriangleMesh> surfaces;
  for (const GraspObject& object : scene.objects) surfaces.push_back(object.surface.mesh);
  MoveItScene messages{robot.model.links.front().name,
                       robot.T_world_base.inverse(),
                       grasps,
                       gripper,
                       arm.T_tip_tool(gripper).inverse(),
                       surfaces,
                       scene.table};
  if (!finger_joints.empty()) messages.finger_joints = comma_separated(finger_joints);
  write_file_atomically(path, is_yaml(path) ? format_moveit_yaml(messages, version())
                                            : format_moveit_json(messages, version()));
}

}  // namespace symscene::app
