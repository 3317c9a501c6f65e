#include "symscene/completion/object_box.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "completion/least_rectangle.hpp"

namespace symscene {
namespace {

/// Points in and on a box about the origin, its corners among them.
Points box_points(const Eigen::Vector3d& size, const Eigen::Isometry3d& pose, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  Points points(200, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Eigen::Vector3d p(uniform(random), uniform(random), uniform(random));
    if (i < 8) p = Eigen::Vector3d(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    points.row(i) = (pose * p.cwiseProduct(size)).cast<float>().transpose();
  }
  return points;
}

Eigen::Isometry3d random_pose(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond turn(normal(random), normal(random), normal(random), normal(random));
  Eigen::Isometry3d pose(turn.normalized());
  pose.pretranslate(Eigen::Vector3d(normal(random), normal(random), normal(random)));
  return pose;
}

Eigen::Vector3d sorted(Eigen::Vector3d v) {
  std::sort(v.begin(), v.end());
  return v;
}

TEST(ObjectBox, HoldsAllPointsAndIsRightHanded) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Points points = box_points({0.1, 0.2, 0.05}, random_pose(seed), seed);
    for (const bool has_table : {false, true}) {
      std::optional<Eigen::Vector3d> up;
      if (has_table) up = Eigen::Vector3d::UnitZ();
      const auto box = object_box(points, std::nullopt, up);
      ASSERT_TRUE(box);
      const Eigen::Isometry3d T_world_box = box->T_world_box.transform();
      EXPECT_NEAR(T_world_box.linear().determinant(), 1.0, 1e-9);
      EXPECT_GE(T_world_box.linear()(2, 2), 0.0) << "z points up";
      for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::Vector3d p =
            T_world_box.inverse() * Eigen::Vector3d(points.row(i).transpose().cast<double>());
        EXPECT_TRUE((p.cwiseAbs().array() <= 0.5 * box->size.array() + 1e-6).all());
      }
    }
  }
}

TEST(ObjectBox, OfABoxThatStandsOnTheTableIsThatBoxAtAnyDistance) {
  for (const double distance : {0.0, 0.4, 3.0}) {
    const Eigen::Vector3d size(0.08, 0.2, 0.12);
    Eigen::Isometry3d pose(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()));
    pose.pretranslate(Eigen::Vector3d(distance, distance, distance));
    const auto box = object_box(box_points(size, pose), std::nullopt, Eigen::Vector3d::UnitZ());
    ASSERT_TRUE(box);
    EXPECT_LT((sorted(box->size) - sorted(size)).norm(), 1e-4);
    EXPECT_NEAR(box->size.z(), 0.12, 1e-4);
    EXPECT_LT((box->T_world_box.position - pose.translation()).norm(), 1e-4);
    EXPECT_EQ(box->T_world_object.position, box->T_world_box.position);
  }
}

ObjectClass class_of(SymmetryClass kind, const Eigen::Isometry3d& pose) {
  ObjectClass found;
  found.kind = kind;
  found.center = pose.translation();
  found.axes = pose.linear();
  return found;
}

TEST(ObjectBox, FollowsTheAxesAndTheCenterOfTheClass) {
  const Eigen::Vector3d size(0.1, 0.2, 0.05);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Eigen::Isometry3d pose = random_pose(seed);
    const Points points = box_points(size, pose, seed);
    for (const SymmetryClass kind :
         {SymmetryClass::mirror, SymmetryClass::prism, SymmetryClass::box, SymmetryClass::n_fold,
          SymmetryClass::revolution, SymmetryClass::cylinder, SymmetryClass::sphere}) {
      const auto box = object_box(points, class_of(kind, pose), Eigen::Vector3d::UnitZ());
      ASSERT_TRUE(box);
      EXPECT_EQ(box->T_world_object.position, pose.translation()) << to_string(kind);
      EXPECT_LT((sorted(box->size) - sorted(size)).norm(), 1e-4) << to_string(kind);
      const Eigen::Matrix3d axes = box->T_world_object.transform().linear();
      const int fixed = kind == SymmetryClass::mirror ? 0 : 2;
      EXPECT_NEAR(std::abs(axes.col(fixed).dot(pose.linear().col(fixed))), 1.0, 1e-6)
          << to_string(kind);
    }
    const auto box = object_box(points, class_of(SymmetryClass::box, pose), std::nullopt);
    EXPECT_LT((box->size - size).norm(), 1e-4) << "edges in the order of the class";
  }
}

TEST(ObjectBox, MovesWithTheObject) {
  const Points points = box_points({0.1, 0.2, 0.05}, Eigen::Isometry3d::Identity());
  const auto before = object_box(points, std::nullopt, std::nullopt);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto after = object_box(box_points({0.1, 0.2, 0.05}, random_pose(seed)), {}, {});
    EXPECT_LT((sorted(after->size) - sorted(before->size)).norm(), 1e-4);
    EXPECT_LT((after->T_world_box.position - random_pose(seed).translation()).norm(), 1e-4);
  }
}

TEST(ObjectBox, IsNoneWithoutPointsAndFlatForOnePoint) {
  EXPECT_FALSE(object_box(Points(0, 3), std::nullopt, std::nullopt));
  Points one(1, 3);
  one << 1.0F, 2.0F, 3.0F;
  const auto box = object_box(one, std::nullopt, Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(box);
  EXPECT_LT(box->size.norm(), 1e-9);
  EXPECT_LT((box->T_world_box.position - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-9);
}

TEST(LeastRectangle, IsNotLargerThanAnyOtherRectangle) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  const auto area = [](const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& along) {
    Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (const Eigen::Vector2d& p : points) {
      const Eigen::Vector2d q(p.dot(along), p.x() * -along.y() + p.y() * along.x());
      low = low.cwiseMin(q);
      high = high.cwiseMax(q);
    }
    return (high - low).prod();
  };
  for (int run = 0; run < 20; ++run) {
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 30; ++i) points.emplace_back(normal(random), 0.3 * normal(random));
    const double least = area(points, least_rectangle(points));
    for (int step = 0; step < 180; ++step) {
      const double angle = step * 0.5 * 3.14159265358979 / 180.0;
      EXPECT_LE(least, area(points, {std::cos(angle), std::sin(angle)}) + 1e-12);
    }
  }
}

TEST(ConvexHull, HasTheCornersOfASquareOnly) {
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {1, 1},   {0.5, 0.5}, {1, 0},
                                               {0, 1}, {0.5, 0}, {1, 1}};
  EXPECT_EQ(convex_hull(points).size(), 4U);
  EXPECT_EQ(convex_hull({{1, 2}}).size(), 1U);
}

}  // namespace
}  // namespace symscene
