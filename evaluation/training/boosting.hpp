#pragma once

#include <map>
#include <string>
#include <vector>

#include "symscene/core/tree_model.hpp"

namespace symscene::bench {

struct BoostingOptions {
  int rounds = 150;             ///< number of trees
  int depth = 3;                ///< greatest number of splits on a path
  double min_leaf = 5.0;        ///< least second derivative of the loss in a leaf
  double rate = 0.1;            ///< learning rate: the share of each step that is taken
  double regularization = 2.0;  ///< L2 penalty of leaves, in units of the second derivative
  double sample_share = 1.0;    ///< share of the samples that a tree sees, drawn at random
  double feature_share = 1.0;   ///< share of the features that a tree sees, drawn at random
  /// Features in which the estimate may only rise (1) or fall (-1).
  std::map<std::string, int> monotone = {};
};

/// Feature values with their target in [0, 1].
struct Sample {
  std::vector<double> features;
  double target = 0.0;
  double weight = 1.0;
};

/// Samples with the names of their features, and the name and origin of the model to be fitted.
struct TrainingSet {
  std::string name;
  std::vector<std::string> features;
  ModelOrigin origin;
  std::vector<Sample> samples;
};

/// Gradient-boosted trees, fitted to the log loss by XGBoost (Chen and Guestrin 2016) with one
/// thread, so that the same samples give the same model. Throws InputError unless there are samples
/// of both kinds.
TreeModel fit_model(const TrainingSet& set, const BoostingOptions& options);

}  // namespace symscene::bench
