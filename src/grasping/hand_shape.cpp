#include "hand_shape.hpp"

#include <cmath>

namespace symscene {
namespace {

/// The two boxes of a finger whose pad is at y = side × opening / 2.
void add_finger(const Gripper& gripper, double opening, double side, double x, double way,
                std::vector<HandBox>& boxes) {
  const double pad = opening / 2.0;
  const auto add = [&](double thickness, double end) {
    const double y = side * (pad + thickness / 2.0);
    const Eigen::Vector3d half(gripper.finger_width / 2.0, thickness / 2.0, 0.0);
    const Eigen::Vector3d start(x, y, -way);
    boxes.push_back(HandBox::between(start - half, Eigen::Vector3d(x, y, end) + half));
  };
  add(gripper.finger_thickness, gripper.finger_depth / 2.0);
  add((gripper.finger_thickness + gripper.tip_thickness) / 2.0, gripper.finger_depth);
}

}  // namespace

HandBox space_between(const Gripper& gripper, double opening) {
  const double x = (gripper.finger_width + gripper.finger_spacing) / 2.0;
  return HandBox::between({-x, -opening / 2.0, 0.0}, {x, opening / 2.0, gripper.finger_depth});
}

HandShape hand_shape(const Gripper& gripper, double opening, double way) {
  HandShape shape;
  for (const double x : {-gripper.finger_spacing / 2.0, gripper.finger_spacing / 2.0}) {
    add_finger(gripper, opening, 1.0, x, way, shape.boxes);
    if (gripper.kind == GripperKind::parallel) break;
  }
  add_finger(gripper, opening, -1.0, 0.0, way, shape.boxes);
  const Eigen::Vector3d half = gripper.palm_size / 2.0;
  shape.boxes.push_back(HandBox::between({-half.x(), -half.y(), -gripper.palm_size.z() - way},
                                         {half.x(), half.y(), 0.0}));
  for (const HandBox& box : shape.boxes)
    shape.reach = std::max(shape.reach, (box.centre.cwiseAbs() + box.half).norm());
  return shape;
}

HandBox box_around(std::span<const HandBox> boxes) {
  Eigen::Vector3f min = boxes.front().centre - boxes.front().half;
  Eigen::Vector3f max = boxes.front().centre + boxes.front().half;
  for (const HandBox& box : boxes) {
    min = min.cwiseMin(box.centre - box.half);
    max = max.cwiseMax(box.centre + box.half);
  }
  return {0.5F * (min + max), 0.5F * (max - min)};
}

Eigen::Matrix3Xf sample_boxes(std::span<const HandBox> boxes, float spacing) {
  std::vector<Eigen::Vector3f> points;
  for (const HandBox& box : boxes) {
    const Eigen::Array3i steps = (2.0F * box.half / spacing).array().ceil().max(1.0F).cast<int>();
    for (int i = 0; i <= steps.x(); ++i) {
      for (int j = 0; j <= steps.y(); ++j) {
        for (int k = 0; k <= steps.z(); ++k) {
          const Eigen::Array3f share =
              Eigen::Array3f(static_cast<float>(i), static_cast<float>(j), static_cast<float>(k)) /
              steps.cast<float>();
          points.emplace_back(box.centre + ((2.0F * share - 1.0F) * box.half.array()).matrix());
        }
      }
    }
  }
  return Eigen::Map<const Eigen::Matrix3Xf>(points.front().data(), 3,
                                            static_cast<Eigen::Index>(points.size()));
}

}  // namespace symscene
