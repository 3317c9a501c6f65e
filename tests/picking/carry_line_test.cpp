#include "picking/carry_line.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace symscene {
namespace {

Eigen::Isometry3d pose(const Eigen::Vector3d& position, double yaw) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(2.8, Eigen::Vector3d(1.0, 0.3, 0.0).normalized()))
                      .toRotationMatrix();
  pose.translation() = position;
  return pose;
}

/// Lines between random poses on both sides of a base.
template <class Check>
void for_each_line(const Check& check) {
  for (int i = 0; i < 20; ++i) {
    const double t = 0.3 * i;
    const Eigen::Isometry3d from = pose({0.4 + 0.1 * std::sin(t), 0.2 * std::cos(t), 0.1}, t);
    const Eigen::Isometry3d goal = pose({0.3 * std::cos(2.0 * t), -0.5, 0.05 + 0.02 * i}, 1.7 * t);
    check(upright_line(from, goal, {-0.1, 0.05}, 0.05 * (i % 3), 0.02), from, goal);
  }
}

TEST(UprightLine, StartsAndEndsWhereItIsAskedTo) {
  for_each_line([](const auto& line, const auto& from, const auto& goal) {
    EXPECT_TRUE(line.front().isApprox(from, 1e-12));
    EXPECT_TRUE(line.back().isApprox(goal, 1e-9));
  });
}

TEST(UprightLine, NeverTiltsTheHandAndNeverSinksBelowBothEnds) {
  for_each_line([](const auto& line, const auto& from, const auto& goal) {
    const double least = std::min(from.translation().z(), goal.translation().z());
    for (const Eigen::Isometry3d& step : line) {
      EXPECT_TRUE(step.linear().row(2).isApprox(from.linear().row(2), 1e-9));
      EXPECT_GE(step.translation().z(), least - 1e-9);
    }
  });
}

TEST(UprightLine, StepsAreShort) {
  for_each_line([](const auto& line, const auto&, const auto&) {
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Eigen::Isometry3d step = line[k - 1].inverse() * line[k];
      EXPECT_LE(step.translation().norm(), 0.0201);
      EXPECT_LE(Eigen::AngleAxisd(step.linear()).angle(), 0.1001);
    }
  });
}

}  // namespace
}  // namespace symscene
