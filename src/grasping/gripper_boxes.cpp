#include "grasping/gripper_boxes.hpp"

#include "hand_shape.hpp"

namespace symscene {
namespace {

Eigen::AlignedBox3d as_aligned_box(const HandBox& box) {
  return {(box.centre - box.half).cast<double>(), (box.centre + box.half).cast<double>()};
}

}  // namespace

std::vector<Eigen::AlignedBox3d> gripper_boxes(const Gripper& gripper, double opening) {
  const HandShape shape = hand_shape(gripper, opening, 0.0);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const HandBox& box : shape.boxes) boxes.push_back(as_aligned_box(box));
  return boxes;
}

Eigen::AlignedBox3d box_between_fingers(const Gripper& gripper, double opening) {
  return as_aligned_box(space_between(gripper, opening));
}

}  // namespace symscene
