#include <gtest/gtest.h>

#include "core/random.hpp"
#include "index_range.hpp"
#include "proposals/selection.hpp"
#include "surfaces.hpp"

namespace symscene {
namespace {

/// An object that owns its points.
struct TestObject {
  PointIndices points;
  double score = 0.0;
  const char* kind = "surface";
};

TestObject object(PointIndices points, double score) { return {std::move(points), score}; }

using Select = std::vector<std::size_t>(const std::vector<SelectionCandidate>&,
                                        const SelectionOptions&, std::vector<Rejection>&);

/// The objects that a function selects.
std::vector<TestObject> selected_by(Select& select, const std::vector<TestObject>& objects,
                                    const SelectionOptions& options,
                                    std::vector<Rejection>& rejected) {
  std::vector<SelectionCandidate> candidates;
  for (const TestObject& each : objects) candidates.push_back({each.points, each.score, each.kind});
  std::vector<TestObject> selected;
  for (const std::size_t k : select(candidates, options, rejected)) selected.push_back(objects[k]);
  return selected;
}

std::vector<TestObject> consistent(const std::vector<TestObject>& objects,
                                   const SelectionOptions& options,
                                   std::vector<Rejection>& rejected) {
  return selected_by(select_consistent, objects, options, rejected);
}

std::vector<TestObject> probable(const std::vector<TestObject>& objects,
                                 const SelectionOptions& options,
                                 std::vector<Rejection>& rejected) {
  return selected_by(select_probable, objects, options, rejected);
}

TEST(Selection, RejectsACompositeOfOtherObjects) {
  std::vector<Rejection> rejected;
  const auto selected = consistent(
      {object(testing::index_range(0, 100), 0.9), object(testing::index_range(0, 50), 0.5),
       object(testing::index_range(50, 98), 0.4)},
      {}, rejected);
  ASSERT_EQ(selected.size(), 2U);
  EXPECT_EQ(selected[0].points, testing::index_range(0, 50));
  ASSERT_EQ(rejected.size(), 1U);
  EXPECT_EQ(rejected[0].reason, "composite");
}

TEST(Selection, PrefersTheWholeToOnePart) {
  std::vector<Rejection> rejected;
  const auto selected = consistent(
      {object(testing::index_range(0, 100), 0.8), object(testing::index_range(10, 40), 0.9)}, {},
      rejected);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0].points.size(), 100U);
  EXPECT_EQ(rejected.at(0).reason, "overlap");
}

TEST(Selection, HasMaximumWeightAmongRandomConflicts) {
  for (const std::uint32_t seed : testing::seeds) {
    Random random(seed);
    std::vector<TestObject> objects;
    for (int k = 0; k < 9; ++k) {
      const Index begin = random.below(60);
      objects.push_back(object(testing::index_range(begin, begin + 10 + random.below(30)),
                               random.uniform(0.1, 1.0)));
    }
    SelectionOptions options;
    options.min_parts_cover = 1.0;  // no composites are rejected
    std::vector<Rejection> rejected;
    double weight = 0.0;
    for (const TestObject& chosen : consistent(objects, options, rejected)) {
      weight += static_cast<double>(chosen.points.size()) * chosen.score;
    }
    double best = 0.0;
    for (unsigned set = 0; set < 1U << objects.size(); ++set) {
      double sum = 0.0;
      bool independent = true;
      for (std::size_t i = 0; i < objects.size(); ++i) {
        if ((set >> i & 1U) == 0) continue;
        sum += static_cast<double>(objects[i].points.size()) * objects[i].score;
        for (std::size_t j = 0; j < i; ++j) {
          if ((set >> j & 1U) == 0) continue;
          const auto smaller = std::min(objects[i].points.size(), objects[j].points.size());
          const auto common = intersection_size(objects[i].points, objects[j].points);
          independent &= 2 * common <= smaller;
        }
      }
      if (independent) best = std::max(best, sum);
    }
    EXPECT_NEAR(weight, best, 1e-9) << "seed " << seed;
  }
}

TEST(Selection, OfManyConflictsIsIndependent) {
  std::vector<TestObject> objects;
  for (Index k = 0; k < 80; ++k) objects.push_back(object(testing::index_range(k, k + 40), 0.5));
  std::vector<Rejection> rejected;
  const std::size_t count = objects.size();
  const auto selected = consistent(objects, {}, rejected);
  EXPECT_EQ(selected.size() + rejected.size(), count);
  for (std::size_t i = 0; i < selected.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_LE(intersection_size(selected[i].points, selected[j].points), 20U);
    }
  }
}

/// The cases are computed by hand for this minimum, which holds for uncovered objects too.
SelectionOptions min_score_of_three_tenths() {
  SelectionOptions options;
  options.min_score = 0.3;
  options.uncovered_ratio = 1.0;
  return options;
}

TEST(Probable, RejectsImprobableObjects) {
  std::vector<Rejection> rejected;
  const auto selected = probable(
      {object(testing::index_range(0, 10), 0.3), object(testing::index_range(20, 30), 0.31),
       object(testing::index_range(40, 45), 0.1)},
      min_score_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0].points, testing::index_range(20, 30));
  ASSERT_EQ(rejected.size(), 2U);
  EXPECT_EQ(rejected[0].kind, "surface");
  EXPECT_EQ(rejected[0].reason, "score");
  EXPECT_EQ(rejected[0].value, 0.3);
  EXPECT_EQ(rejected[0].bound, 0.3);
  EXPECT_EQ(rejected[0].size, 10U);
  EXPECT_EQ(rejected[0].points, testing::index_range(0, 10));
  EXPECT_EQ(rejected[1].points, testing::index_range(40, 45));
  EXPECT_TRUE(probable({}, min_score_of_three_tenths(), rejected).empty());
}

TEST(Probable, RejectsAnOverlapAboveHalfOfTheSmaller) {
  std::vector<Rejection> rejected;
  // 50 of 100 shared points are not more than half, 51 are.
  EXPECT_EQ(probable({object(testing::index_range(0, 100), 0.5),
                      object(testing::index_range(50, 200), 0.6)},
                     min_score_of_three_tenths(), rejected)
                .size(),
            2U);
  EXPECT_TRUE(rejected.empty());
  TestObject round = object(testing::index_range(0, 100), 0.5);
  round.kind = "rotational";
  const auto selected = probable({round, object(testing::index_range(49, 200), 0.6)},
                                 min_score_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0].points, testing::index_range(49, 200));
  ASSERT_EQ(rejected.size(), 1U);
  EXPECT_EQ(rejected[0].kind, "rotational");
  EXPECT_EQ(rejected[0].reason, "overlap");
  EXPECT_EQ(rejected[0].value, 0.51);
  EXPECT_EQ(rejected[0].bound, 0.5);
  EXPECT_EQ(rejected[0].points, testing::index_range(0, 100));
}

TEST(Probable, ComparesTwoPartsWithTheWhole) {
  const auto with_parts_of = [](double score) {
    std::vector<Rejection> rejected;
    return probable(
        {object(testing::index_range(0, 100), 0.9), object(testing::index_range(0, 50), score),
         object(testing::index_range(50, 100), score)},
        min_score_of_three_tenths(), rejected);
  };
  // Weights: the whole 0.9 - 0.3 = 0.6; its parts 2 * 0.35 = 0.7, then 2 * 0.25 = 0.5.
  const auto parts = with_parts_of(0.65);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].points, testing::index_range(0, 50));
  EXPECT_EQ(parts[1].points, testing::index_range(50, 100));
  const auto whole = with_parts_of(0.55);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].points, testing::index_range(0, 100));
}

TEST(Probable, CountsTheMinimumScoreAsTheCostOfAWrongObject) {
  // At 0.1 the weights of the case above are 2 * 0.45 for the parts and 0.8 for the whole.
  SelectionOptions options;
  options.min_score = 0.1;
  std::vector<Rejection> rejected;
  EXPECT_EQ(probable({object(testing::index_range(0, 100), 0.9),
                      object(testing::index_range(0, 50), 0.55),
                      object(testing::index_range(50, 100), 0.55)},
                     options, rejected)
                .size(),
            2U);
}

TEST(Probable, FindsManyPartsOfOneWhole) {
  // 30 parts of weight 0.3 conflict with one whole that weighs more than any: a component of 31.
  std::vector<TestObject> objects{object(testing::index_range(0, 300), 0.99)};
  for (Index k = 0; k < 30; ++k)
    objects.push_back(object(testing::index_range(10 * k, 10 * k + 10), 0.6));
  std::vector<Rejection> rejected;
  const auto selected = probable(objects, min_score_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 30U);
  for (Index k = 0; k < 30; ++k)
    EXPECT_EQ(selected[k].points, testing::index_range(10 * k, 10 * k + 10));
  ASSERT_EQ(rejected.size(), 1U);
  EXPECT_EQ(rejected[0].reason, "overlap");
  EXPECT_EQ(rejected[0].value, 1.0);
  EXPECT_EQ(rejected[0].size, 300U);
}

TEST(Probable, FindsOneWholeOfManyParts) {
  std::vector<TestObject> objects;
  for (Index k = 0; k < 30; ++k)
    objects.push_back(object(testing::index_range(10 * k, 10 * k + 10), 0.31));
  objects.push_back(object(testing::index_range(0, 300), 0.99));
  std::vector<Rejection> rejected;
  const auto selected = probable(objects, min_score_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0].points.size(), 300U);
  EXPECT_EQ(rejected.size(), 30U);
}

TEST(Probable, ChoosesEverySecondLinkOfALongChain) {
  // Each link shares 15 of its 25 points with the next. The even ones score higher.
  std::vector<TestObject> objects;
  for (Index k = 0; k < 41; ++k)
    objects.push_back(object(testing::index_range(10 * k, 10 * k + 25), k % 2 == 0 ? 0.7 : 0.6));
  std::vector<Rejection> rejected;
  const auto selected = probable(objects, min_score_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 21U);
  for (Index k = 0; k < 21; ++k)
    EXPECT_EQ(selected[k].points, testing::index_range(20 * k, 20 * k + 25));
  EXPECT_EQ(rejected.size(), 20U);
}

TEST(Probable, ChoosesALessLikelyObjectWhereNoOtherCoversIt) {
  SelectionOptions options;
  options.min_score = 0.4;
  options.uncovered_ratio = 0.5;
  options.uncovered_size = 0.25;
  std::vector<Rejection> rejected;
  const auto selected =
      probable({object(testing::index_range(0, 100), 0.9),
                object(testing::index_range(200, 300), 0.3),   // nothing else covers it
                object(testing::index_range(40, 130), 0.3),    // mostly covered by the first
                object(testing::index_range(150, 320), 0.25),  // less likely than the second
                object(testing::index_range(400, 424), 0.39),  // a fragment
                object(testing::index_range(500, 600), 0.2)},  // not above 0.5 * 0.4
               options, rejected);
  ASSERT_EQ(selected.size(), 2U);
  EXPECT_EQ(selected[0].points, testing::index_range(0, 100));
  EXPECT_EQ(selected[1].points, testing::index_range(200, 300));
  EXPECT_EQ(rejected.size(), 4U);
}

TEST(Probable, ChoosesUncoveredObjectsOfAnySizeWithoutLikelierOnes) {
  std::vector<Rejection> rejected;
  SelectionOptions options;
  options.min_score = 0.4;
  options.uncovered_ratio = 0.5;
  const auto selected = probable(
      {object(testing::index_range(0, 100), 0.3), object(testing::index_range(0, 50), 0.25)},
      options, rejected);
  ASSERT_EQ(selected.size(), 1U);
  EXPECT_EQ(selected[0].points, testing::index_range(0, 100));
}

TEST(Probable, UncertainPartsOutweighTheirUncertainUnion) {
  // With a cost of min_score per object the union would win: 0.38 - 0.2 against 0.04 + 0.03 + 0.01.
  SelectionOptions options;
  options.min_score = 0.4;
  options.uncovered_ratio = 0.5;
  std::vector<Rejection> rejected;
  const auto selected = probable(
      {object(testing::index_range(0, 300), 0.38), object(testing::index_range(0, 100), 0.24),
       object(testing::index_range(100, 200), 0.23), object(testing::index_range(200, 300), 0.21)},
      options, rejected);
  ASSERT_EQ(selected.size(), 3U);
  EXPECT_EQ(selected[0].points, testing::index_range(0, 100));
  ASSERT_EQ(rejected.size(), 1U);
  EXPECT_EQ(rejected[0].points.size(), 300U);
}

TEST(Probable, KeepsTheOrder) {
  std::vector<Rejection> rejected;
  const auto selected = probable(
      {object(testing::index_range(50, 60), 0.4), object(testing::index_range(0, 10), 0.9),
       object(testing::index_range(20, 30), 0.2), object(testing::index_range(30, 40), 0.6)},
      min_score_of_three_tenths(), rejected);
  ASSERT_EQ(selected.size(), 3U);
  EXPECT_EQ(selected[0].points, testing::index_range(50, 60));
  EXPECT_EQ(selected[1].points, testing::index_range(0, 10));
  EXPECT_EQ(selected[2].points, testing::index_range(30, 40));
}

}  // namespace
}  // namespace symscene
