#pragma once

#include <random>
#include <vector>

#include "grasp_scenes.hpp"
#include "grasping/hand_shape.hpp"
#include "grasping/target.hpp"

/// Shapes, hands and scenes from a seed. [m]
namespace symscene::testing {

/// Every point of a surface has a sample within this distance.
constexpr double sampling_bound = 0.0045;
/// Samples are means of neighbours and so lie up to this far from the surface, on its inside.
constexpr double sample_offset = 0.002;

inline double between_of(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Eigen::Matrix3d random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  return q.normalized().toRotationMatrix();
}

/// A box, a cylinder, a bowl or a body of ellipsoids, with triangles of any size, in any
/// orientation about the origin.
inline TriangleMesh random_shape(std::mt19937& random) {
  const auto any = [&](double low, double high) { return between_of(random, low, high); };
  TriangleMesh mesh;
  switch (std::uniform_int_distribution<int>(0, 3)(random)) {
    case 0:
      mesh = make_box({any(0.01, 0.1), any(0.01, 0.1), any(0.01, 0.15)}, any(0.003, 0.2));
      break;
    case 1:
      mesh = cylinder_at(any(0.01, 0.05), any(0.03, 0.15), 0.0, 0.0).surface.mesh;
      break;
    case 2:
      mesh = bowl(any(0.04, 0.1)).surface.mesh;
      break;
    default: {
      const std::vector<Ellipsoid> parts{
          {{0.0, 0.0, 0.03}, {any(0.02, 0.06), any(0.02, 0.04), any(0.02, 0.05)}},
          {{any(0.0, 0.04), 0.0, 0.04}, {any(0.01, 0.03), any(0.01, 0.05), any(0.01, 0.04)}}};
      mesh = make_mirrored_body(parts, 0.01, any(0.004, 0.01));
    }
  }
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = random_rotation(random);
  return transformed(mesh, turn);
}

/// A shape that touches the table z = 0.
inline GraspObject random_object(std::mt19937& random, double x, double y) {
  const TriangleMesh mesh = random_shape(random);
  const double low = static_cast<double>(mesh.vertices.col(2).minCoeff());
  return seen_all_over(shifted(mesh, {x, y, -low}));
}

/// Nine objects beside each other; some of them may intersect.
inline GraspScene random_scene(std::mt19937& random) {
  std::vector<GraspObject> objects;
  for (const double x : {-0.14, 0.0, 0.14}) {
    for (const double y : {-0.14, 0.0, 0.14}) {
      objects.push_back(random_object(random, x + between_of(random, -0.02, 0.02),
                                      y + between_of(random, -0.02, 0.02)));
    }
  }
  return on_table(objects);
}

inline Gripper random_gripper(std::mt19937& random, GripperKind kind) {
  const auto any = [&](double low, double high) { return between_of(random, low, high); };
  Gripper gripper;
  gripper.kind = kind;
  gripper.max_opening = any(0.03, 0.16);
  gripper.finger_depth = any(0.03, 0.12);
  gripper.finger_width = any(0.01, 0.03);
  gripper.finger_thickness = any(0.01, 0.03);
  gripper.tip_thickness = any(0.005, gripper.finger_thickness);
  if (kind == GripperKind::three_finger)
    gripper.finger_spacing = any(gripper.finger_width, 3.0 * gripper.finger_width);
  gripper.approach_distance = any(0.0, 0.1);
  gripper.palm_size = {any(0.03, 0.1), any(0.05, 0.2), any(0.03, 0.15)};
  return gripper;
}

/// Palm and fingers of a hand that comes from `way` along −z.
inline std::vector<HandBox> hand_boxes(const Gripper& gripper, double opening, double way) {
  return hand_shape(gripper, opening, way).boxes;
}

/// What the fingers of the open hand enclose.
inline HandBox space_between_fingers(const Gripper& gripper) {
  return space_between(gripper, gripper.max_opening);
}

}  // namespace symscene::testing
