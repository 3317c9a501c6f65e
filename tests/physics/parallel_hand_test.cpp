#include "symscene/physics/parallel_hand.hpp"

#include <gtest/gtest.h>

#include <array>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// How far a shape reaches in a direction, in its mesh's frame.
struct Reach {
  Eigen::Vector3f direction;
  float value;  // over the length of the direction [m]
};

/// The greatest coordinate of the corners along the direction, if `origin` is that of the mesh's
/// frame along z of the tool frame.
float reach(const ConvexParts& parts, const Eigen::Vector3f& direction, float origin) {
  const Eigen::Vector3f n = direction.normalized();
  float greatest = -1.0F;
  for (const Points& corners : parts)
    greatest = std::max(greatest, (corners.matrix() * n).maxCoeff() - (origin * n.z()));
  return greatest;
}

TEST(PandaParallelHand, ItsPalmReachesAsFarAsTheCollisionMesh) {
  // Of panda/meshes/collision/hand.obj of the benchmark. The tool frame is 62 mm along z.
  constexpr float tolerance = 1e-3F;
  const std::array<Reach, 18> mesh{{{{1, 0, 0}, 0.0316F},
                                    {{-1, 0, 0}, 0.0316F},
                                    {{0, 1, 0}, 0.1004F},
                                    {{0, -1, 0}, 0.1040F},
                                    {{0, 0, 1}, 0.0660F},
                                    {{0, 0, -1}, 0.0259F},
                                    {{1, -1, 0}, 0.0819F},
                                    {{-1, -1, 0}, 0.0818F},
                                    {{1, -1, -1}, 0.0678F},
                                    {{-1, -1, -1}, 0.0678F},
                                    {{1, 1, -1}, 0.0650F},
                                    {{-1, 1, -1}, 0.0648F},
                                    {{0, 1, -1}, 0.0642F},
                                    {{0, -1, -1}, 0.0825F},
                                    {{5, -1, -1}, 0.0331F},
                                    {{-5, -1, -1}, 0.0333F},
                                    {{1, 1, 1}, 0.0998F},
                                    {{-1, -1, 1}, 0.0996F}}};
  for (const auto& [direction, value] : mesh)
    EXPECT_NEAR(reach(panda_parallel_hand().palm, direction, -0.062F), value, tolerance)
        << direction.transpose();
}

TEST(PandaParallelHand, ItsFingersReachAsFarAsTheCollisionMesh) {
  // Of panda/meshes/collision/finger.obj, 58.4 mm along z from the frame of the hand.
  constexpr float tolerance = 6e-4F;
  const std::array<Reach, 11> mesh{{{{1, 0, 0}, 0.0105F},
                                    {{-1, 0, 0}, 0.0105F},
                                    {{0, 1, 0}, 0.0264F},
                                    {{0, -1, 0}, 0.0001F},
                                    {{0, 0, 1}, 0.0538F},
                                    {{0, 0, -1}, -0.0001F},
                                    {{1, 1, 1}, 0.0427F},
                                    {{-1, 1, 1}, 0.0429F},
                                    {{0, -1, 1}, 0.0381F},
                                    {{0, 1, -1}, 0.0186F},
                                    {{0, 1, 1}, 0.0482F}}};
  for (const auto& [direction, value] : mesh)
    EXPECT_NEAR(reach(panda_parallel_hand().finger, direction, -0.0036F), value, tolerance)
        << direction.transpose();
}

TEST(ParallelHandOfAGripper, HasTheExtentsOfItsBoxes) {
  Gripper gripper;
  gripper.finger_thickness = 0.02;
  gripper.tip_thickness = 0.01;
  const ParallelHand hand = parallel_hand_of(gripper);
  constexpr float tolerance = 1e-6F;
  EXPECT_NEAR(reach(hand.palm, {0, 1, 0}, 0.0F), 0.1F, tolerance);
  EXPECT_NEAR(reach(hand.palm, {0, 0, 1}, 0.0F), 0.0F, tolerance);
  EXPECT_NEAR(reach(hand.palm, {0, 0, -1}, 0.0F), 0.1F, tolerance);
  EXPECT_NEAR(reach(hand.finger, {0, 1, 0}, 0.0F), 0.02F, tolerance);
  EXPECT_NEAR(reach(hand.finger, {0, -1, 0}, 0.0F), 0.0F, tolerance);
  EXPECT_NEAR(reach(hand.finger, {0, 0, 1}, 0.0F), 0.05F, tolerance);
  // At the tip it is as thick as the tip: the farthest corner along (0, 1, 10).
  const float along = reach(hand.finger, {0, 1, 10}, 0.0F);
  EXPECT_NEAR(along * std::sqrt(101.0F), 0.01F + 10 * 0.05F, 1e-5F);
}

TEST(ParallelHandOfAGripper, RefusesThreeFingers) {
  Gripper gripper;
  gripper.kind = GripperKind::three_finger;
  gripper.finger_spacing = 0.06;
  EXPECT_THROW(parallel_hand_of(gripper), InputError);
}

}  // namespace
}  // namespace symscene
