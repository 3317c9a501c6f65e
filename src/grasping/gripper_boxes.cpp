#include "grasping/gripper_boxes.hpp"

#include "hand_shape.hpp"

namespace symscene {

std::vector<Eigen::AlignedBox3d> gripper_boxes(const Gripper& gripper, double opening) {
  const HandShape shape = hand_shape(gripper, opening, 0.0);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const HandBox& box : shape.boxes) {
    boxes.emplace_back((box.centre - box.half).cast<double>(),
                       (box.centre + box.half).cast<double>());
  }
  return boxes;
}

}  // namespace symscene
