#pragma once

#include <span>
#include <vector>

namespace symscene::bench {

struct BoostingOptions {
  int rounds = 150;
  int depth = 3;
  int min_leaf = 20;            ///< samples
  double rate = 0.1;            ///< share of each tree's step that is taken
  double regularization = 2.0;  ///< of leaves, in units of the second derivative
};

/// A question, or a leaf where `feature` is below 0.
struct TreeNode {
  int feature = -1;
  float bound = 0.0F;  ///< the left branch, which is the next node, is for values up to here
  int right = 0;       ///< node of the other branch, counted from this one
  double value = 0.0;  ///< what a leaf adds to the log-odds
};
using Tree = std::vector<TreeNode>;

/// Log-odds as a sum over trees (Friedman 2001), fitted by second-order steps to the log loss.
struct BoostedTrees {
  double base = 0.0;
  std::vector<Tree> trees;

  double log_odds(std::span<const double> features) const;
  double probability(std::span<const double> features) const;
};

/// A row of features with its target in [0, 1].
struct Sample {
  std::vector<double> features;
  double target = 0.0;
};

/// Deterministic: there is no sampling. Questions are asked at 63 quantiles of each feature.
/// Throws InputError without samples of both kinds.
BoostedTrees fit_trees(const std::vector<Sample>& samples, const BoostingOptions& options);

}  // namespace symscene::bench
