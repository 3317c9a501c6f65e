#include "symscene/reconstruction/trajectory_error.hpp"

#include <gtest/gtest.h>

#include <random>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using Poses = std::vector<Eigen::Isometry3d>;

Eigen::Isometry3d pose(double angle, const Eigen::Vector3d& place) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 2) / 3.0).matrix();
  T.translation() = place;
  return T;
}

/// A wavy path that turns as it goes.
Poses wavy(int count) {
  Poses poses;
  for (int k = 0; k < count; ++k) {
    poses.push_back(pose(0.02 * k, {0.01 * k, 0.1 * std::sin(0.3 * k), 0.1 * std::cos(0.2 * k)}));
  }
  return poses;
}

/// Steps of 10 cm along x, straight on.
Poses straight(int count, double step = 0.1) {
  Poses poses;
  for (int k = 0; k < count; ++k) poses.push_back(pose(0.0, {step * k, 0, 0}));
  return poses;
}

TEST(TrajectoryError, OfAPathThatIsRightIsZeroWhereverItsWorldIs) {
  const Poses truth = wavy(50);
  for (const auto& T : {pose(0.0, {0, 0, 0}), pose(0.0, {1, -2, 3}), pose(1.3, {-4, 0.5, 2})}) {
    Poses moved;
    for (const auto& t : truth) moved.push_back(T * t);
    const TrajectoryError error = trajectory_error(moved, truth);
    EXPECT_EQ(error.poses, 50U);
    EXPECT_NEAR(error.absolute, 0.0, 1e-9);
    EXPECT_NEAR(error.absolute_max, 0.0, 1e-9);
    EXPECT_NEAR(error.relative, 0.0, 1e-9);
    EXPECT_NEAR(error.relative_angle, 0.0, 1e-7);
    EXPECT_NEAR(error.drift, 0.0, 1e-9);
  }
}

TEST(TrajectoryError, OfAPathThatIsTooLongIsWorkedOutByHand) {
  // Places −2, −1, 0, 1, 2 times the step about their middle: each is off by a tenth of that.
  const TrajectoryError error = trajectory_error(straight(5, 0.11), straight(5), 1);
  EXPECT_NEAR(error.absolute, 0.01 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(error.absolute_max, 0.02, 1e-9);
  EXPECT_NEAR(error.relative, 0.01, 1e-9);
  EXPECT_NEAR(error.drift, 0.04, 1e-9);
  EXPECT_NEAR(error.length, 0.4, 1e-9);
  EXPECT_NEAR(trajectory_error(straight(5, 0.11), straight(5), 2).relative, 0.02, 1e-9);
}

TEST(TrajectoryError, OfOneSlipShowsAsDriftAndInOneStep) {
  const Poses truth = straight(11);
  Poses slipped = truth;
  for (std::size_t k = 6; k < slipped.size(); ++k) slipped[k].translation().y() += 0.03;
  const TrajectoryError error = trajectory_error(slipped, truth, 1);
  EXPECT_NEAR(error.drift, 0.03, 1e-9);
  EXPECT_NEAR(error.relative, 0.03 / std::sqrt(10.0), 1e-9);
  EXPECT_EQ(error.relative_angle, 0.0);
}

TEST(TrajectoryError, OfATurnIsItsAngle) {
  Poses turned = straight(5);
  for (std::size_t k = 1; k < turned.size(); ++k) {
    turned[k].linear() =
        Eigen::AngleAxisd(0.1 * static_cast<double>(k), Eigen::Vector3d::UnitX()).matrix();
  }
  const TrajectoryError error = trajectory_error(turned, straight(5), 1);
  EXPECT_NEAR(error.absolute, 0.0, 1e-9);
  EXPECT_NEAR(error.relative_angle, 0.1, 1e-9);
  EXPECT_NEAR(error.relative, 0.0, 1e-9) << "it turns about the way that it goes";
}

TEST(TrajectoryError, DoesNotMirrorAPathToMakeItFit) {
  Poses truth = wavy(40), mirrored = truth;
  for (auto& T : mirrored) T.translation().x() *= -1.0;
  EXPECT_GT(trajectory_error(mirrored, truth).absolute, 0.02);
}

TEST(TrajectoryError, GrowsWithNoise) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0.0, 1.0);
  double last = 0.0;
  for (const double noise : {0.001, 0.01, 0.1}) {
    Poses noisy = wavy(200);
    for (auto& T : noisy) {
      T.translation() += noise * Eigen::Vector3d(normal(random), normal(random), normal(random));
    }
    const TrajectoryError error = trajectory_error(noisy, wavy(200));
    EXPECT_NEAR(error.absolute, std::sqrt(3.0) * noise, 0.15 * noise);
    EXPECT_GE(error.absolute_max, error.absolute);
    EXPECT_GT(error.absolute, last);
    last = error.absolute;
  }
}

TEST(TrajectoryError, OfShortPathsIsANumber) {
  EXPECT_EQ(trajectory_error({}, {}).poses, 0U);
  EXPECT_EQ(trajectory_error(straight(1), straight(1)).absolute, 0.0);
  for (const int count : {2, 3, 4}) {
    for (const std::size_t interval : {0U, 1U, 30U}) {
      const TrajectoryError error =
          trajectory_error(straight(count, 0.12), straight(count), interval);
      EXPECT_TRUE(std::isfinite(error.absolute + error.relative + error.drift));
      EXPECT_NEAR(error.drift, 0.02 * (count - 1), 1e-9);
    }
  }
  const Poses still(10, pose(0.3, {1, 2, 3}));
  EXPECT_NEAR(trajectory_error(still, still).absolute, 0.0, 1e-9);
  EXPECT_EQ(trajectory_error(still, still).length, 0.0);
}

TEST(TrajectoryError, RefusesPathsOfUnequalLength) {
  EXPECT_THROW(trajectory_error(straight(3), straight(4)), InputError);
  EXPECT_THROW(trajectory_error({}, straight(1)), InputError);
}

}  // namespace
}  // namespace symscene
