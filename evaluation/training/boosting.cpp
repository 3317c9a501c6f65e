#include "boosting.hpp"

#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <xgboost/c_api.h>
#include <nlohmann/json.hpp>

#include "symscene/core/error.hpp"

namespace symscene::bench {
namespace {

using nlohmann::json;

void require_success(int status) {
  if (status != 0) throw InputError("XGBoost", "success", XGBGetLastError());
}

/// Samples in the form that XGBoost reads.
class Matrix {
 public:
  explicit Matrix(const TrainingSet& set) {
    std::vector<float> values, targets, weights;
    for (const Sample& sample : set.samples) {
      values.insert(values.end(), sample.features.begin(), sample.features.end());
      targets.push_back(static_cast<float>(sample.target));
      weights.push_back(static_cast<float>(sample.weight));
    }
    require_success(XGDMatrixCreateFromMat(values.data(), set.samples.size(), set.features.size(),
                                           std::numeric_limits<float>::quiet_NaN(), &handle_));
    require_success(XGDMatrixSetFloatInfo(handle_, "label", targets.data(), targets.size()));
    require_success(XGDMatrixSetFloatInfo(handle_, "weight", weights.data(), weights.size()));
  }
  ~Matrix() { XGDMatrixFree(handle_); }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;

  DMatrixHandle get() const { return handle_; }

 private:
  DMatrixHandle handle_ = nullptr;
};

class Booster {
 public:
  explicit Booster(const Matrix& matrix) : matrix_(matrix) {
    const DMatrixHandle matrices[] = {matrix.get()};
    require_success(XGBoosterCreate(matrices, 1, &handle_));
  }
  ~Booster() { XGBoosterFree(handle_); }
  Booster(const Booster&) = delete;
  Booster& operator=(const Booster&) = delete;

  void set(const std::string& name, const std::string& value) {
    require_success(XGBoosterSetParam(handle_, name.c_str(), value.c_str()));
  }

  void run(int rounds) {
    for (int round = 0; round < rounds; ++round)
      require_success(XGBoosterUpdateOneIter(handle_, round, matrix_.get()));
  }

  json model() const {
    bst_ulong length = 0;
    const char* text = nullptr;
    require_success(XGBoosterSaveModelToBuffer(handle_, R"({"format": "json"})", &length, &text));
    return json::parse(text, text + length);
  }

 private:
  const Matrix& matrix_;
  BoosterHandle handle_ = nullptr;
};

/// The depth-first nodes of XGBoost's tree from `node` on. XGBoost's lower branch holds values
/// below the bound, ours those up to it.
void append_nodes(const json& tree, std::size_t node, Tree& nodes) {
  const std::size_t here = nodes.size();
  const auto value = tree["split_conditions"][node].get<float>();
  const int lower = tree["left_children"][node], upper = tree["right_children"][node];
  if (lower < 0) {
    nodes.push_back({-1, 0, value});
    return;
  }
  const float bound = std::nextafter(value, -std::numeric_limits<float>::infinity());
  nodes.push_back({tree["split_indices"][node].get<std::int32_t>(), 0, bound});
  append_nodes(tree, static_cast<std::size_t>(lower), nodes);
  nodes[here].upper = static_cast<std::int32_t>(nodes.size() - here);
  append_nodes(tree, static_cast<std::size_t>(upper), nodes);
}

std::vector<Tree> trees_of(const json& model) {
  std::vector<Tree> trees;
  for (const json& tree : model["learner"]["gradient_booster"]["model"]["trees"])
    append_nodes(tree, 0, trees.emplace_back());
  return trees;
}

/// The share of the targets' weight that is positive.
double positive_share(const TrainingSet& set) {
  double positive = 0.0, all = 0.0;
  for (const Sample& sample : set.samples) {
    positive += sample.weight * sample.target;
    all += sample.weight;
  }
  if (!(positive > 0.0 && positive < all))
    throw InputError("samples", "positive and negative ones", "one kind only");
  return positive / all;
}

/// XGBoost's list of one constraint per feature.
std::string constraints_of(const TrainingSet& set, const std::map<std::string, int>& monotone) {
  std::string list;
  for (const std::string& feature : set.features) {
    const auto own = monotone.find(feature);
    list += fmt::format("{}{}", list.empty() ? "(" : ",", own == monotone.end() ? 0 : own->second);
  }
  return list + ")";
}

}  // namespace

TreeModel fit_model(const TrainingSet& set, const BoostingOptions& options) {
  if (set.samples.empty()) throw InputError("samples", "at least one", "none");
  const double share = positive_share(set);
  const Matrix matrix(set);
  Booster booster(matrix);
  booster.set("objective", "binary:logistic");
  booster.set("tree_method", "hist");
  booster.set("nthread", "1");  // sums in a fixed order
  booster.set("verbosity", "0");
  booster.set("base_score", fmt::format("{}", share));
  booster.set("max_depth", fmt::format("{}", options.depth));
  booster.set("eta", fmt::format("{}", options.rate));
  booster.set("lambda", fmt::format("{}", options.regularization));
  booster.set("min_child_weight", fmt::format("{}", options.min_leaf));
  booster.set("subsample", fmt::format("{}", options.sample_share));
  booster.set("colsample_bytree", fmt::format("{}", options.feature_share));
  booster.set("seed", "1");
  booster.set("monotone_constraints", constraints_of(set, options.monotone));
  booster.run(options.rounds);
  return {set.name, set.features, static_cast<float>(std::log(share / (1.0 - share))),
          trees_of(booster.model()), set.origin};
}

}  // namespace symscene::bench
