#include "symscene/dataset/split.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

std::vector<std::string> names_of(const std::vector<ObjectModel>& models) {
  std::vector<std::string> names;
  for (const ObjectModel& model : models) names.push_back(model.name);
  return names;
}

std::vector<ObjectModel> models_called(const std::vector<std::string>& names) {
  std::vector<ObjectModel> models;
  for (const std::string& name : names) models.push_back({name, {}, {}, {}, false});
  return models;
}

TEST(Split, NoSeedOccursTwice) {
  std::set<std::uint64_t> seeds;
  std::size_t count = 0;
  for (const Split split : {Split::training, Split::test}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      for (std::size_t index = 0; index < 89; ++index) {
        for (std::size_t attempt = 0; attempt < 4; ++attempt, ++count) {
          seeds.insert(scene_seed(seed, split, index, attempt));
          EXPECT_EQ(scene_seed(seed, split, index, attempt) % 2, split == Split::test ? 1U : 0U);
        }
      }
    }
  }
  EXPECT_EQ(seeds.size(), count);
  EXPECT_LT(*seeds.rbegin(), std::uint64_t{1} << 53U);
}

TEST(Split, EveryNumberOfObjectsOccursEquallyOften) {
  std::map<int, int> uses;
  for (std::size_t i = 0; i < 89; ++i) ++uses[object_count(7, Split::test, i, 1, 15)];
  EXPECT_EQ(uses.size(), 15U);
  for (const auto& [count, times] : uses) {
    EXPECT_GE(times, 5) << count;
    EXPECT_LE(times, 6) << count;
  }
  EXPECT_EQ(object_count(7, Split::test, 3, 4, 4), 4);
}

TEST(Split, FamiliesOfModelsGoToOneSplitAndTheOtherInTurn) {
  const auto models = models_called({"c-2", "a", "c-1", "b", "d-x", "cc"});
  EXPECT_EQ(names_of(models_of(Split::training, models)),
            (std::vector<std::string>{"a", "c-1", "c-2", "d-x"}));
  EXPECT_EQ(names_of(models_of(Split::test, models)), (std::vector<std::string>{"b", "cc"}));
  EXPECT_TRUE(models_of(Split::test, {}).empty());
}

TEST(Split, IsReadByItsNameAndByTheNameInOlderDatasets) {
  for (const Split split : {Split::training, Split::test})
    EXPECT_EQ(parse_split(to_string(split), "there"), split);
  EXPECT_EQ(parse_split("tune", "there"), Split::training);
  EXPECT_EQ(parse_split("report", "there"), Split::test);
}

TEST(Split, OfAnotherNameIsRefused) {
  EXPECT_THROW(parse_split("validation", "there"), InputError);
}

}  // namespace
}  // namespace symscene
