#pragma once

#include <string>
#include <vector>

#include "symscene/core/tree_model.hpp"

namespace symscene::bench {

struct BoostingOptions {
  int rounds = 150;             ///< number of trees
  int depth = 3;                ///< greatest number of splits on a path
  int min_leaf = 20;            ///< least number of samples of a leaf
  double rate = 0.1;            ///< learning rate: the share of each step that is taken
  double regularization = 2.0;  ///< L2 penalty of leaves, in units of the second derivative
};

/// Feature values with their target in [0, 1].
struct Sample {
  std::vector<double> features;
  double target = 0.0;
};

/// Samples with the names of their features, and the name and origin of the model to be fitted.
struct TrainingSet {
  std::string name;
  std::vector<std::string> features;
  ModelOrigin origin;
  std::vector<Sample> samples;
};

/// Gradient-boosted trees (Friedman 2001) by second-order steps on the log loss, with splits at 63
/// quantiles of each feature. Deterministic. Throws InputError unless there are samples of both
/// kinds.
TreeModel fit_model(const TrainingSet& set, const BoostingOptions& options);

}  // namespace symscene::bench
