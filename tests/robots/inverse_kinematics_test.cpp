#include "symscene/robots/inverse_kinematics.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "random_positions.hpp"
#include "small_robots.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

ArmChain whole_chain(const RobotModel& model) {
  return arm_chain(model, make_arm(model, "arm", "link0", model.links.back().name));
}

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

double greatest_difference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

void expect_within_limits(const ArmChain& chain, const Eigen::VectorXd& q) {
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    EXPECT_GE(q[static_cast<Eigen::Index>(i)], chain.joints[i].lower);
    EXPECT_LE(q[static_cast<Eigen::Index>(i)], chain.joints[i].upper);
  }
}

TEST(ArmChain, PutsTheTipWhereLinkPosesDo) {
  RobotModel model = seven_joint_arm();
  model.joints[3].kind = JointKind::prismatic;
  const ArmChain chain = whole_chain(model);
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Eigen::VectorXd q = random_positions(chain, random);
    EXPECT_LT(greatest_difference(tip_pose(chain, q), link_poses(model, q).back()), 1e-12);
  }
}

TEST(ArmChain, IsNoShorterThanTheTipReaches) {
  const ArmChain chain = whole_chain(seven_joint_arm());
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d tip = tip_pose(chain, random_positions(chain, random)).translation();
    EXPECT_LE((tip - Eigen::Vector3d(0.0, 0.0, 0.3)).norm(), chain.length());
  }
}

TEST(ArmChain, HasTheJacobianOfFiniteDifferences) {
  RobotModel model = seven_joint_arm();
  model.joints[2].kind = JointKind::prismatic;
  const ArmChain chain = whole_chain(model);
  Random random(3);
  constexpr double h = 1e-5;
  for (int trial = 0; trial < 10; ++trial) {
    const Eigen::VectorXd q = random_positions(chain, random);
    const auto J = tip_jacobian(chain, q);
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      const Eigen::VectorXd change = h * Eigen::VectorXd::Unit(q.size(), i);
      const Eigen::Isometry3d before = tip_pose(chain, q - change);
      const Eigen::Isometry3d after = tip_pose(chain, q + change);
      const Eigen::Vector3d turn = rotation_vector(after.linear() * before.linear().transpose());
      EXPECT_LT((J.col(i).head<3>() - turn / (2.0 * h)).norm(), 1e-7);
      const Eigen::Vector3d shift = after.translation() - before.translation();
      EXPECT_LT((J.col(i).tail<3>() - shift / (2.0 * h)).norm(), 1e-7);
    }
  }
}

TEST(InverseKinematics, ReachesPosesOfRandomPositions) {
  const ArmChain chain = whole_chain(seven_joint_arm());
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Isometry3d T = tip_pose(chain, random_positions(chain, random));
    const InverseKinematicsResult result = inverse_kinematics(chain, T);
    ASSERT_TRUE(result.converged()) << i;
    EXPECT_LT(greatest_difference(tip_pose(chain, result.positions), T), 5e-6);
    expect_within_limits(chain, result.positions);
  }
}

/// Whether a small motion in the null space brings the positions no nearer to the reference.
bool is_nearest(const ArmChain& chain, const Eigen::VectorXd& q, const Eigen::VectorXd& reference) {
  const Eigen::MatrixXd J = tip_jacobian(chain, q);
  const Eigen::VectorXd null = J.jacobiSvd(Eigen::ComputeFullV).matrixV().rightCols<1>();
  return std::abs(null.dot(reference - q)) < 0.02;
}

TEST(InverseKinematics, UsesTheRedundancyToStayNearTheReference) {
  const ArmChain chain = whole_chain(seven_joint_arm());
  const Eigen::VectorXd middle = middle_of_limits(chain);
  Random random(5);
  InverseKinematicsOptions plain;
  plain.refinements = 0;
  constexpr int poses = 50;
  int nearest = 0;
  for (int i = 0; i < poses; ++i) {
    const Eigen::Isometry3d T = tip_pose(chain, random_positions(chain, random));
    const auto refined = inverse_kinematics(chain, T, middle);
    const auto first = inverse_kinematics(chain, T, middle, plain);
    EXPECT_LE((refined.positions - middle).norm(), (first.positions - middle).norm() + 1e-12);
    nearest += is_nearest(chain, refined.positions, middle) ? 1 : 0;
  }
  // Not all: joints may be at their limits.
  EXPECT_GT(nearest, poses / 2);
}

TEST(InverseKinematics, LeavesJointsUnchangedWhenTheBaseMoves) {
  const RobotModel model = seven_joint_arm();
  RobotModel moved = model;
  const Eigen::Isometry3d motion =
      Eigen::Translation3d(1.0, -2.0, 0.5) *
      Eigen::AngleAxisd(1.2, Eigen::Vector3d(1.0, 2.0, 3.0).normalized());
  moved.joints[0].T_parent_joint = motion * moved.joints[0].T_parent_joint;
  const ArmChain chain = whole_chain(model), other = whole_chain(moved);
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Isometry3d T = tip_pose(chain, random_positions(chain, random));
    const auto a = inverse_kinematics(chain, T), b = inverse_kinematics(other, motion * T);
    EXPECT_LT((a.positions - b.positions).cwiseAbs().maxCoeff(), 1e-4);
  }
}

TEST(InverseKinematics, GivesTheSameBytesForTheSameSeed) {
  const ArmChain chain = whole_chain(seven_joint_arm());
  Random random(7);
  const Eigen::Isometry3d T = tip_pose(chain, random_positions(chain, random));
  EXPECT_EQ(inverse_kinematics(chain, T).positions, inverse_kinematics(chain, T).positions);
  const Eigen::VectorXd middle = middle_of_limits(chain);
  EXPECT_EQ(inverse_kinematics_solutions(chain, T, middle, 5),
            inverse_kinematics_solutions(chain, T, middle, 5));
}

TEST(InverseKinematics, FindsDistinctSolutionsTheNearestFirst) {
  const ArmChain chain = whole_chain(seven_joint_arm());
  Random random(8);
  const Eigen::Isometry3d T = tip_pose(chain, random_positions(chain, random));
  const InverseKinematicsOptions options;
  const auto solutions =
      inverse_kinematics_solutions(chain, T, middle_of_limits(chain), 6, options);
  ASSERT_EQ(solutions.size(), 6U);
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    EXPECT_LT(greatest_difference(tip_pose(chain, solutions[i]), T), 5e-6);
    expect_within_limits(chain, solutions[i]);
    if (i > 0) {
      // All ranges are the same, so that the distance is the plain one.
      EXPECT_LE((solutions[i - 1] - middle_of_limits(chain)).norm(),
                (solutions[i] - middle_of_limits(chain)).norm() + 1e-12);
    }
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE((solutions[i] - solutions[j]).cwiseAbs().maxCoeff(), options.distinct);
  }
}

TEST(InverseKinematics, SaysHowFarAnUnreachablePoseIs) {
  const ArmChain chain = whole_chain(planar_arm());
  Eigen::Isometry3d T(Eigen::Translation3d(0.6, 0.0, 0.0));
  const auto point = inverse_kinematics_of_point(chain, T.translation(), middle_of_limits(chain));
  EXPECT_FALSE(point.converged());
  EXPECT_NEAR(point.position_error, 0.1, 1e-3);
  EXPECT_FALSE(inverse_kinematics(chain, T).converged());
  T.translation().x() = 0.3;
  EXPECT_TRUE(
      inverse_kinematics_of_point(chain, T.translation(), middle_of_limits(chain)).converged());
}

TEST(InverseKinematics, TurnsAContinuousJointAcrossTheEndOfItsRange) {
  RobotModel model = single_link();
  add_link(model, 0, Eigen::Isometry3d::Identity(), Eigen::Vector3d::UnitZ(),
           JointKind::continuous);
  model.joints[0].limits = {-radians(180.0), radians(180.0), 1.0, 1.0};
  const ArmChain chain = whole_chain(model);
  const Eigen::Isometry3d T(Eigen::AngleAxisd(radians(-170.0), Eigen::Vector3d::UnitZ()));
  InverseKinematicsOptions options;
  options.max_starts = 1;
  const auto result =
      inverse_kinematics(chain, T, Eigen::VectorXd::Constant(1, radians(170.0)), options);
  ASSERT_TRUE(result.converged());
  EXPECT_NEAR(result.positions[0], radians(-170.0), 1e-5);
}

TEST(InverseKinematics, HandlesArmsWithoutLengthOrJoints) {
  RobotModel model = single_link();
  for (std::size_t i = 0; i < 3; ++i)
    add_link(model, i, Eigen::Isometry3d::Identity(),
             Eigen::Vector3d::Unit(static_cast<Eigen::Index>(i)));
  const ArmChain wrist = whole_chain(model);
  const Eigen::Isometry3d T = tip_pose(wrist, Eigen::Vector3d(0.3, -0.4, 0.5));
  EXPECT_TRUE(inverse_kinematics(wrist, T).converged());
  const Eigen::Isometry3d shifted = Eigen::Translation3d(0.1, 0.0, 0.0) * T;
  const auto missed = inverse_kinematics(wrist, shifted);
  EXPECT_FALSE(missed.converged());
  EXPECT_TRUE(missed.positions.allFinite());
  EXPECT_NEAR(missed.position_error, 0.1, 1e-9);

  const ArmChain none = whole_chain(single_link());
  EXPECT_TRUE(inverse_kinematics(none, Eigen::Isometry3d::Identity()).converged());
  EXPECT_FALSE(inverse_kinematics(none, shifted).converged());
}

TEST(InverseKinematics, RefusesWhatIsNotFinite) {
  const ArmChain chain = whole_chain(planar_arm());
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation().x() = NAN;
  EXPECT_THROW(inverse_kinematics(chain, T), InputError);
  EXPECT_THROW(inverse_kinematics(chain, Eigen::Isometry3d::Identity(), Eigen::VectorXd::Zero(5)),
               InputError);
}

}  // namespace
}  // namespace symscene
