#include "training/boosting.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "symscene/core/error.hpp"

namespace symscene::bench {
namespace {

/// Positive inside a rectangle of the first two features; the third one is noise.
TrainingSet rectangle(std::uint64_t seed, std::size_t count) {
  TrainingSet set{"rectangle", {"x", "y", "noise"}, {"a command", "2026-11-28", "random"}, {}};
  Random random(seed);
  for (std::size_t k = 0; k < count; ++k) {
    Sample sample{{random.uniform(), random.uniform(), random.uniform()}, 0.0};
    sample.target = sample.features[0] > 0.4 && sample.features[1] < 0.5 ? 1.0 : 0.0;
    set.samples.push_back(std::move(sample));
  }
  return set;
}

TEST(Boosting, SeparatesUnseenSamplesByTheFeaturesThatDecide) {
  const TreeModel model = fit_model(rectangle(1, 2000), {});
  EXPECT_EQ(model.trees(), 150U);
  std::size_t wrong = 0;
  for (const Sample& sample : rectangle(2, 1000).samples)
    wrong += (model.probability(sample.features) > 0.5) != (sample.target > 0.5) ? 1 : 0;
  EXPECT_LT(wrong, 50U);
  EXPECT_GT(model.probability(std::array{0.7, 0.2, 0.5}), 0.9);
  EXPECT_LT(model.probability(std::array{0.1, 0.2, 0.5}), 0.1);
  EXPECT_LT(model.probability(std::array{0.7, 0.9, 0.5}), 0.1);
}

TEST(Boosting, WritesAModelThatIsReadBackWithTheSameBits) {
  const TreeModel model = fit_model(rectangle(3, 500), {});
  const std::string text = format_tree_model(model);
  const TreeModel read = parse_tree_model(text, "rectangle.txt");
  EXPECT_EQ(format_tree_model(read), text);
  EXPECT_EQ(read.origin().command, "a command");
  for (const Sample& sample : rectangle(4, 50).samples)
    EXPECT_EQ(read.probability(sample.features), model.probability(sample.features));
}

TEST(Boosting, IsDeterministic) {
  EXPECT_EQ(format_tree_model(fit_model(rectangle(5, 300), {})),
            format_tree_model(fit_model(rectangle(5, 300), {})));
}

TEST(Boosting, RespectsDepthAndLeafSize) {
  BoostingOptions options;
  options.depth = 1;
  options.rounds = 10;
  const TreeModel stumps = fit_model(rectangle(6, 300), options);
  ASSERT_EQ(stumps.trees(), 10U);
  for (std::size_t k = 0; k < stumps.trees(); ++k) EXPECT_LE(stumps.tree(k).size(), 3U);
  options.min_leaf = 200;
  const TreeModel leaves = fit_model(rectangle(6, 300), options);
  for (std::size_t k = 0; k < leaves.trees(); ++k) EXPECT_EQ(leaves.tree(k).size(), 1U);
}

TEST(Boosting, RefusesSamplesOfOneKind) {
  TrainingSet set = rectangle(7, 50);
  for (Sample& sample : set.samples) sample.target = 1.0;
  EXPECT_THROW(fit_model(set, {}), InputError);
  set.samples.clear();
  EXPECT_THROW(fit_model(set, {}), InputError);
}

}  // namespace
}  // namespace symscene::bench
