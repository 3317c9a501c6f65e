#include "symscene/evaluation/symmetry_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/symmetry_targets.hpp"

namespace symscene {
namespace {

const SymmetryTolerance one_centimetre;

RotationAxis vertical(double x, double tilt_degrees = 0.0) {
  const double tilt = radians(tilt_degrees);
  return {{x, 0, 0}, {std::sin(tilt), 0, std::cos(tilt)}};
}

ReflectionPlane across(const Eigen::Vector3d& normal, const Eigen::Vector3d& point) {
  return {point, normal.normalized()};
}

TrueObject can_at(double x) {
  TrueObject can;
  can.rotational.push_back({vertical(x), true});
  can.centroid = {x, 0, 0};
  return can;
}

TEST(MatchAxes, CountsAxesWithinBothTolerances) {
  SceneTruth truth;
  truth.objects = {can_at(0.0), can_at(0.3)};
  const RotationAxis found[] = {vertical(0.005, 9.0), vertical(0.315)};
  const SymmetryMatch match = match_axes(truth, found, one_centimetre);
  EXPECT_EQ(match.truth_met, (std::vector<bool>{true, false}));
  EXPECT_EQ(match.right, 1U);
  EXPECT_EQ(match.wrong, 1U);
  EXPECT_DOUBLE_EQ(match.detections().precision(), 0.5);
  EXPECT_EQ(match_axes(truth, found, {radians(10), 0.1}).right, 2U);
  EXPECT_EQ(match_axes(truth, found, {radians(5), 0.1}).right, 1U);
}

TEST(MatchAxes, MeasuresPositionAtTheCentroidNotAtTheAxisPoint) {
  SceneTruth truth;
  truth.objects = {can_at(0.0)};
  RotationAxis same_line = vertical(0.0);
  same_line.point.z() = 5.0;
  same_line.direction = -same_line.direction;
  EXPECT_EQ(match_axes(truth, std::vector{same_line}, one_centimetre).right, 1U);
}

TEST(MatchAxes, TheSecondAxisAtOneTrueAxisIsWrong) {
  SceneTruth truth;
  truth.objects = {can_at(0.0)};
  const RotationAxis found[] = {vertical(0.004), vertical(0.001)};
  const SymmetryMatch match = match_axes(truth, found, one_centimetre);
  EXPECT_EQ(match.right, 1U);
  EXPECT_EQ(match.wrong, 1U);
}

TEST(MatchAxes, AnyAxisThroughTheCentreOfASphereIsRightAndTheSphereCountsOnce) {
  SceneTruth truth;
  truth.objects.emplace_back();
  truth.objects[0].sphere = true;
  const RotationAxis found[] = {vertical(0.004, 60.0), vertical(0.001, 20.0), vertical(0.1)};
  const SymmetryMatch match = match_axes(truth, found, one_centimetre);
  EXPECT_EQ(match.truth_met, (std::vector<bool>{true}));
  EXPECT_EQ(match.right, 1U);
  EXPECT_EQ(match.neither, 1U);
  EXPECT_EQ(match.wrong, 1U);
}

TEST(MatchPlanes, FindsThreePlanesOfABoxWhateverTheSignOfTheNormal) {
  TrueObject box;
  for (int axis = 0; axis < 3; ++axis) {
    box.reflectional.push_back({across(Eigen::Vector3d::Unit(axis), {0, 0, 0}), true});
  }
  SceneTruth truth;
  truth.objects = {box};
  const ReflectionPlane found[] = {across({-1, 0.05, 0}, {0.002, 0.1, 0.3}),
                                   across({0, 1, 0}, {0, -0.003, 0}), across({1, 1, 0}, {0, 0, 0})};
  const SymmetryMatch match = match_planes(truth, found, one_centimetre);
  EXPECT_EQ(match.truth_met, (std::vector<bool>{true, true, false}));
  EXPECT_EQ(match.wrong, 1U);
  EXPECT_DOUBLE_EQ(match.detections().recall(), 2.0 / 3.0);
}

TEST(MatchPlanes, PlanesThroughTheAxisOfARotationalObjectDoNotCount) {
  SceneTruth truth;
  truth.objects = {can_at(0.2)};
  const ReflectionPlane found[] = {across({1, 2, 0}, {0.2, 0, 0.7}),  // holds the axis
                                   across({1, 0, 0}, {0.23, 0, 0}),   // beside it
                                   across({0, 0, 1}, {0.2, 0, 0})};   // across it
  const SymmetryMatch match = match_planes(truth, found, one_centimetre);
  EXPECT_EQ(match.neither, 1U);
  EXPECT_EQ(match.wrong, 2U);
  EXPECT_TRUE(match.truth_met.empty());
}

TEST(MatchPlanes, WeakPlanesDoNotCount) {
  TrueObject carton;
  carton.reflectional.push_back({across({1, 1, 0}, {0, 0, 0}), false});
  SceneTruth truth;
  truth.objects = {carton};
  const SymmetryMatch match =
      match_planes(truth, std::vector{across({1, 1, 0}, {0.004, 0, 0})}, one_centimetre);
  EXPECT_EQ(match.neither, 1U);
  EXPECT_EQ(match.detections().found, 0U);
  EXPECT_DOUBLE_EQ(match.detections().precision(), 1.0);
}

TEST(MatchPlanes, AStrictMatchPrecedesAnExcuse) {
  TrueObject box;
  box.reflectional.push_back({across({0, 1, 0}, {0, 0, 0}), true});
  SceneTruth truth;
  truth.objects = {box, can_at(0.3)};  // the can's axis stands in the box's plane
  EXPECT_EQ(match_planes(truth, std::vector{across({0, 1, 0}, {0, 0, 0})}, one_centimetre).right,
            1U);
}

TEST(MatchPlanes, ATruePlaneThroughTheAxisOfItsObjectNeedNotBeFound) {
  TrueObject can = can_at(0.0);
  can.reflectional.push_back({across({0, 1, 0}, {0, 0, 0}), true});  // holds the axis
  can.reflectional.push_back({across({0, 0, 1}, {0, 0, 0}), true});  // stands across it
  TrueObject weak = can;
  weak.rotational.front().strict = false;
  TrueObject ball;
  ball.sphere = true;
  ball.reflectional.push_back({across({1, 0, 0}, {0, 0, 0}), true});
  SceneTruth truth;
  for (const TrueObject& object : {can, weak, ball}) {
    truth.objects = {object};
    const SymmetryMatch match =
        match_planes(truth, std::vector{across({0, 1, 0}, {0, 0, 0})}, one_centimetre);
    EXPECT_EQ(match.neither, 1U);
    EXPECT_EQ(match.wrong, 0U);
  }
  truth.objects = {can, weak, ball};
  EXPECT_EQ(plane_targets(truth), (std::vector<std::size_t>{1, 1, 0}));
  EXPECT_EQ(axis_targets(truth), (std::vector<std::size_t>{1, 0, 1}));
}

TEST(IsSymmetryOf, IncludesWeakAndImpliedSymmetries) {
  TrueObject can = can_at(0.0);
  can.rotational.front().strict = false;
  EXPECT_TRUE(is_symmetry_of(can, vertical(0.004, 3.0)));
  EXPECT_FALSE(is_symmetry_of(can, vertical(0.02)));
  EXPECT_TRUE(is_symmetry_of(can, across({1, 3, 0}, {0, 0, 0})));
  EXPECT_FALSE(is_symmetry_of(can, across({0, 0, 1}, {0, 0, 0})));
  TrueObject ball;
  ball.sphere = true;
  EXPECT_TRUE(is_symmetry_of(ball, vertical(0.0, 70.0)));
}

TEST(AllSymmetries, ArePooledOverTheObjects) {
  std::vector<SceneObject> objects(2);
  objects[0].rotational.push_back({vertical(0.1), 0.0});
  objects[1].rotational.push_back({vertical(0.2), 0.0});
  objects[1].reflectional.push_back({across({1, 0, 0}, {0, 0, 0}), 0.0});
  EXPECT_EQ(all_axes(objects).size(), 2U);
  EXPECT_EQ(all_planes(objects).size(), 1U);
}

}  // namespace
}  // namespace symscene
