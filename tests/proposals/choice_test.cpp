#include <numeric>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "surfaces.hpp"
#include "symscene/core/error.hpp"
#include "symscene/proposals/merge.hpp"
#include "symscene/proposals/selection.hpp"
#include "symscene/symmetry/object_symmetry.hpp"

namespace symscene {
namespace {

PointIndices range(Index begin, Index end) {
  PointIndices indices(end - begin);
  std::iota(indices.begin(), indices.end(), begin);
  return indices;
}

SceneObject object(PointIndices points, double score) {
  SceneObject object;
  object.points = std::move(points);
  object.score = score;
  return object;
}

PointCloud hundred_points() {
  PointCloud cloud;
  cloud.positions = Points::Zero(200, 3);
  for (Index i = 0; i < 200; ++i) cloud.positions(i, 0) = 0.001F * static_cast<float>(i);
  return cloud;
}

TEST(Merge, JoinsEqualMasksWithAllTheirSymmetries) {
  const ReflectionPlane x{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()};
  const ReflectionPlane y{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY()};
  std::vector<RatedHypothesis> rated(3);
  rated[0] = {{range(0, 100), {}, {}, {{x, 0.1}}}, 0.5};
  rated[1] = {{range(0, 99), {}, {}, {{y, 0.2}}}, 0.9};
  rated[2] = {{range(0, 60), {}, {}, {{x, 0.0}}}, 0.4};
  const std::vector<SceneObject> objects = merge_hypotheses(rated, hundred_points());
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].points, range(0, 99));
  EXPECT_EQ(objects[0].score, 0.9);
  EXPECT_EQ(objects[0].reflectional.size(), 2U);
  EXPECT_EQ(objects[1].reflectional.size(), 1U);
}

TEST(Merge, KeepsASymmetryOnce) {
  const ReflectionPlane plane{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY()};
  const ReflectionPlane nearly{{0.0, 0.002, 0.0}, -Eigen::Vector3d(0.02, 1.0, 0.0).normalized()};
  std::vector<RatedHypothesis> rated(2);
  rated[0] = {{range(0, 100), {}, {}, {{plane, 0.1}}}, 0.5};
  rated[1] = {{range(0, 100), {}, {}, {{nearly, 0.1}}}, 0.4};
  const std::vector<SceneObject> objects = merge_hypotheses(rated, hundred_points());
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].reflectional.size(), 1U);
}

TEST(Selection, LetsACompositeGiveWayToItsParts) {
  std::vector<Rejection> rejected;
  const auto selected = select_consistent(
      {object(range(0, 100), 0.9), object(range(0, 50), 0.5), object(range(50, 98), 0.4)}, {},
      rejected);
  ASSERT_EQ(selected.size(), 2U);
  EXPECT_EQ(selected[0].points, range(0, 50));
  ASSERT_EQ(rejected.size(), 1U);
  EXPECT_EQ(rejected[0].reason, "composite");
}

TEST(Selection, LetsAPieceGiveWayToTheWhole) {
  std::vector<Rejection> rejected;
  const auto selected =
      select_consistent({object(range(0, 100), 0.8), object(range(10, 40), 0.9)}, {}, rejected);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0].points.size(), 100U);
  EXPECT_EQ(rejected.at(0).reason, "overlap");
}

TEST(Selection, IsTheWorthiestSetOfRandomRivals) {
  for (const std::uint32_t seed : testing::seeds) {
    Random random(seed);
    std::vector<SceneObject> objects;
    for (int k = 0; k < 9; ++k) {
      const Index begin = random.below(60);
      objects.push_back(
          object(range(begin, begin + 10 + random.below(30)), random.uniform(0.1, 1.0)));
    }
    SelectionOptions options;
    options.min_parts_cover = 1.0;  // composites stay: the choice alone
    std::vector<Rejection> rejected;
    double worth = 0.0;
    for (const SceneObject& chosen : select_consistent(objects, options, rejected)) {
      worth += static_cast<double>(chosen.points.size()) * chosen.score;
    }
    double best = 0.0;
    for (unsigned set = 0; set < 1U << objects.size(); ++set) {
      double sum = 0.0;
      bool admissible = true;
      for (std::size_t i = 0; i < objects.size(); ++i) {
        if ((set >> i & 1U) == 0) continue;
        sum += static_cast<double>(objects[i].points.size()) * objects[i].score;
        for (std::size_t j = 0; j < i; ++j) {
          if ((set >> j & 1U) == 0) continue;
          const auto smaller = std::min(objects[i].points.size(), objects[j].points.size());
          const auto common = intersection_size(objects[i].points, objects[j].points);
          admissible &= 2 * common <= smaller;
        }
      }
      if (admissible) best = std::max(best, sum);
    }
    EXPECT_NEAR(worth, best, 1e-9) << "seed " << seed;
  }
}

TEST(Selection, OfManyRivalsEndsAndIsConsistent) {
  std::vector<SceneObject> objects;
  for (Index k = 0; k < 80; ++k) objects.push_back(object(range(k, k + 40), 0.5));
  std::vector<Rejection> rejected;
  const std::size_t count = objects.size();
  const auto selected = select_consistent(std::move(objects), {}, rejected);
  EXPECT_EQ(selected.size() + rejected.size(), count);
  for (std::size_t i = 0; i < selected.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_LE(intersection_size(selected[i].points, selected[j].points), 20U);
    }
  }
}

TEST(Merge, KnowsTheSameSetByItsOverlap) {
  EXPECT_TRUE(is_same_set(range(0, 100), range(0, 100), 0.95));
  EXPECT_TRUE(is_same_set(range(0, 96), range(0, 100), 0.95));
  EXPECT_TRUE(is_same_set(range(0, 100), range(0, 96), 0.95));
  EXPECT_FALSE(is_same_set(range(0, 95), range(0, 100), 0.95));  // 0.95 is not more
  EXPECT_FALSE(is_same_set(range(0, 100), range(10, 110), 0.95));
  EXPECT_TRUE(is_same_set(range(0, 100), range(10, 110), 0.8));  // 90 of 110
  EXPECT_FALSE(is_same_set(range(0, 50), range(50, 100), 0.0));
  EXPECT_FALSE(is_same_set({}, {}, 0.5));
}

/// Worked by hand with a least probability of 0.3.
SelectionOptions least_of_three_tenths() {
  SelectionOptions options;
  options.min_score = 0.3;
  return options;
}

TEST(Probable, LeavesOutWhatIsNotProbableEnough) {
  std::vector<Rejection> rejected;
  const auto selected = select_probable(
      {object(range(0, 10), 0.3), object(range(20, 30), 0.31), object(range(40, 45), 0.1)},
      least_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0].points, range(20, 30));
  ASSERT_EQ(rejected.size(), 2U);
  EXPECT_EQ(rejected[0].kind, "surface");
  EXPECT_EQ(rejected[0].reason, "score");
  EXPECT_EQ(rejected[0].value, 0.3);
  EXPECT_EQ(rejected[0].bound, 0.3);
  EXPECT_EQ(rejected[0].size, 10U);
  EXPECT_EQ(rejected[0].points, range(0, 10));
  EXPECT_EQ(rejected[1].points, range(40, 45));
  EXPECT_TRUE(select_probable({}, least_of_three_tenths(), rejected).empty());
}

TEST(Probable, ExcludesWhatSharesMoreThanHalfOfTheSmaller) {
  std::vector<Rejection> rejected;
  // 50 of 100 points are shared, which is not more than half, then 51.
  EXPECT_EQ(select_probable({object(range(0, 100), 0.5), object(range(50, 200), 0.6)},
                            least_of_three_tenths(), rejected)
                .size(),
            2U);
  EXPECT_TRUE(rejected.empty());
  SceneObject round = object(range(0, 100), 0.5);
  round.rotational.emplace_back();
  const auto selected =
      select_probable({round, object(range(49, 200), 0.6)}, least_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0].points, range(49, 200));
  ASSERT_EQ(rejected.size(), 1U);
  EXPECT_EQ(rejected[0].kind, "rotational");
  EXPECT_EQ(rejected[0].reason, "overlap");
  EXPECT_EQ(rejected[0].value, 0.51);
  EXPECT_EQ(rejected[0].bound, 0.5);
  EXPECT_EQ(rejected[0].points, range(0, 100));
}

TEST(Probable, WeighsTwoPartsAgainstTheWhole) {
  const auto with_parts_of = [](double score) {
    std::vector<Rejection> rejected;
    return select_probable(
        {object(range(0, 100), 0.9), object(range(0, 50), score), object(range(50, 100), score)},
        least_of_three_tenths(), rejected);
  };
  // The whole is worth 0.9 − 0.3 = 0.6; its parts 2 · 0.35 = 0.7, then 2 · 0.25 = 0.5.
  const auto parts = with_parts_of(0.65);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].points, range(0, 50));
  EXPECT_EQ(parts[1].points, range(50, 100));
  const auto whole = with_parts_of(0.55);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].points, range(0, 100));
}

TEST(Probable, PricesAWrongObjectAtTheLeastScore) {
  // At 0.1 the parts of the case above are worth 2 · 0.45 and the whole 0.8.
  SelectionOptions options;
  options.min_score = 0.1;
  std::vector<Rejection> rejected;
  EXPECT_EQ(select_probable({object(range(0, 100), 0.9), object(range(0, 50), 0.55),
                             object(range(50, 100), 0.55)},
                            options, rejected)
                .size(),
            2U);
}

TEST(Probable, FindsThePartsOfAWholeAmongManyRivals) {
  // 30 parts, each worth 0.3, rival one whole that is worth more than any: 31 rivals.
  std::vector<SceneObject> objects{object(range(0, 300), 0.99)};
  for (Index k = 0; k < 30; ++k) objects.push_back(object(range(10 * k, 10 * k + 10), 0.6));
  std::vector<Rejection> rejected;
  const auto selected = select_probable(objects, least_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 30U);
  for (Index k = 0; k < 30; ++k) EXPECT_EQ(selected[k].points, range(10 * k, 10 * k + 10));
  ASSERT_EQ(rejected.size(), 1U);
  EXPECT_EQ(rejected[0].reason, "overlap");
  EXPECT_EQ(rejected[0].value, 1.0);
  EXPECT_EQ(rejected[0].size, 300U);
}

TEST(Probable, FindsTheWholeAmongManyRivals) {
  std::vector<SceneObject> objects;
  for (Index k = 0; k < 30; ++k) objects.push_back(object(range(10 * k, 10 * k + 10), 0.31));
  objects.push_back(object(range(0, 300), 0.99));
  std::vector<Rejection> rejected;
  const auto selected = select_probable(objects, least_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0].points.size(), 300U);
  EXPECT_EQ(rejected.size(), 30U);
}

TEST(Probable, TakesEverySecondLinkOfALongChain) {
  // Each link shares 15 of its 25 points with the next. The even ones are the better.
  std::vector<SceneObject> objects;
  for (Index k = 0; k < 41; ++k)
    objects.push_back(object(range(10 * k, 10 * k + 25), k % 2 == 0 ? 0.7 : 0.6));
  std::vector<Rejection> rejected;
  const auto selected = select_probable(objects, least_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 21U);
  for (Index k = 0; k < 21; ++k) EXPECT_EQ(selected[k].points, range(20 * k, 20 * k + 25));
  EXPECT_EQ(rejected.size(), 20U);
}

TEST(Probable, KeepsTheOrder) {
  std::vector<Rejection> rejected;
  const auto selected = select_probable({object(range(50, 60), 0.4), object(range(0, 10), 0.9),
                                         object(range(20, 30), 0.2), object(range(30, 40), 0.6)},
                                        least_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 3U);
  EXPECT_EQ(selected[0].points, range(50, 60));
  EXPECT_EQ(selected[1].points, range(0, 10));
  EXPECT_EQ(selected[2].points, range(30, 40));
}

TEST(ObjectSymmetry, OfAVaseIsItsAxisAtAnyScaleAndPlace) {
  for (const double scale : {0.001, 1.0, 800.0}) {
    std::mt19937 generator(9);
    const Eigen::Isometry3d motion = testing::random_motion(generator);
    PointCloud cloud = testing::moved(testing::vase(), motion);
    cloud.positions *= static_cast<float>(scale);
    const ObjectSymmetries found = detect_object_symmetries(cloud);
    ASSERT_EQ(found.rotational.size(), 1U) << "scale " << scale;
    const RotationAxis truth{scale * motion.translation(),
                             motion.linear() * Eigen::Vector3d::UnitZ()};
    const SymmetryDifference apart = difference(found.rotational[0].axis, truth, found.centroid);
    EXPECT_LT(apart.angle, radians(1.0));
    EXPECT_LT(apart.distance, 0.003 * scale);
    EXPECT_TRUE(found.reflectional.empty());
    EXPECT_FALSE(found.sphere);
  }
}

TEST(ObjectSymmetry, OfABoxIsItsThreePlanesWithAndWithoutNormals) {
  PointCloud cloud = testing::box({0.1, 0.16, 0.23});
  for (const bool with_normals : {true, false}) {
    if (!with_normals) cloud.normals.resize(0, 3);
    const ObjectSymmetries found = detect_object_symmetries(cloud);
    EXPECT_EQ(found.reflectional.size(), 3U) << with_normals;
    EXPECT_TRUE(found.rotational.empty());
  }
}

TEST(ObjectSymmetry, OfABallIsSaidToBeASphere) {
  const std::vector<Ellipsoid> ball{{{0.0, 0.0, 0.1}, {0.05, 0.05, 0.05}}};
  const ObjectSymmetries found =
      detect_object_symmetries(testing::as_cloud(make_mirrored_body(ball, 0.001, 0.005)));
  EXPECT_TRUE(found.sphere);
  EXPECT_LT((found.centroid - Eigen::Vector3d(0.0, 0.0, 0.1)).norm(), 0.002);
}

TEST(ObjectSymmetry, OfOnePointIsRefused) {
  PointCloud cloud = select(testing::vase(), PointIndices{0});
  EXPECT_THROW(detect_object_symmetries(cloud), InputError);
  EXPECT_THROW(detect_object_symmetries(PointCloud{}), InputError);
}

}  // namespace
}  // namespace symscene
