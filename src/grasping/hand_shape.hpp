#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "symscene/core/gripper.hpp"

namespace symscene {

/// An axis-aligned box of the tool frame. [m]
struct HandBox {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  Eigen::Vector3f half = Eigen::Vector3f::Zero();

  static HandBox between(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
    return {(0.5 * (min + max)).cast<float>(), (0.5 * (max - min)).cast<float>()};
  }
  /// Distance of a point from the box; inside it the negative depth. [m]
  float distance(const Eigen::Vector3f& p) const {
    const Eigen::Vector3f outside = (p - centre).cwiseAbs() - half;
    const float deepest = outside.maxCoeff();
    return deepest <= 0.0F ? deepest : outside.cwiseMax(0.0F).norm();
  }
};

/// A gripper as boxes of its tool frame: each finger as a thick half and a thinner half, as fingers
/// taper, and the palm.
struct HandShape {
  std::vector<HandBox> boxes;  ///< two per finger, then one of the palm
  float reach = 0.0F;          ///< greatest distance of the boxes from the origin [m]

  std::span<const HandBox> fingers() const { return {boxes.data(), boxes.size() - 1}; }
  std::span<const HandBox> palm() const { return {&boxes.back(), 1}; }
};

/// The space between the fingers.
HandBox space_between(const Gripper& gripper, double opening);

/// `way`: how far the gripper comes from along −z; the boxes are those that it sweeps. [m]
HandShape hand_shape(const Gripper& gripper, double opening, double way);

/// The least box that holds the boxes.
HandBox box_around(std::span<const HandBox> boxes);

/// Points on and inside boxes, at most `spacing` apart.
Eigen::Matrix3Xf sample_boxes(std::span<const HandBox> boxes, float spacing);

}  // namespace symscene
