#include "boosting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "symscene/core/error.hpp"

namespace symscene::bench {
namespace {

constexpr std::size_t quantiles = 64;

/// Rounded to single precision, in which models compare values.
double rounded(double value) { return static_cast<double>(static_cast<float>(value)); }

std::vector<double> bounds_of(const std::vector<Sample>& samples, std::size_t feature) {
  std::vector<double> values;
  for (const Sample& sample : samples) values.push_back(rounded(sample.features[feature]));
  std::sort(values.begin(), values.end());
  std::vector<double> bounds;
  for (std::size_t q = 1; q < quantiles; ++q) {
    const double bound = values[values.size() * q / quantiles];
    if (bound < values.back() && (bounds.empty() || bound > bounds.back())) bounds.push_back(bound);
  }
  return bounds;
}

/// Sums of the first and second derivatives of the loss.
struct Derivatives {
  double slope = 0.0;
  double curvature = 0.0;
  int samples = 0;

  Derivatives& operator+=(const Derivatives& other) {
    slope += other.slope;
    curvature += other.curvature;
    samples += other.samples;
    return *this;
  }
};

Derivatives operator-(Derivatives a, const Derivatives& b) {
  return {a.slope - b.slope, a.curvature - b.curvature, a.samples - b.samples};
}

class Booster {
 public:
  Booster(const std::vector<Sample>& samples, const BoostingOptions& options)
      : samples_(samples), options_(options), derivatives_(samples.size()) {
    const std::size_t features = samples.front().features.size();
    for (std::size_t f = 0; f < features; ++f) bounds_.push_back(bounds_of(samples, f));
    for (const Sample& sample : samples) {
      auto& row = bins_.emplace_back(features);
      for (std::size_t f = 0; f < features; ++f) {
        const auto& bounds = bounds_[f];
        const auto at = std::lower_bound(bounds.begin(), bounds.end(), rounded(sample.features[f]));
        row[f] = static_cast<std::uint8_t>(at - bounds.begin());
      }
    }
  }

  /// The trees and the log-odds before them.
  std::pair<float, std::vector<Tree>> fit() {
    std::vector<Tree> trees;
    double positive = 0.0;
    for (const Sample& sample : samples_) positive += sample.target;
    const double negative = static_cast<double>(samples_.size()) - positive;
    if (!(positive > 0.0 && negative > 0.0))
      throw InputError("samples", "positive and negative ones", "one kind only");
    const double base = std::log(positive / negative);
    std::vector<double> odds(samples_.size(), base);
    for (int round = 0; round < options_.rounds; ++round) {
      for (std::size_t i = 0; i < odds.size(); ++i) {
        const double p = 1.0 / (1.0 + std::exp(-odds[i]));
        derivatives_[i] = {samples_[i].target - p, std::max(p * (1.0 - p), 1e-4), 1};
      }
      std::vector<std::size_t> all(samples_.size());
      std::iota(all.begin(), all.end(), std::size_t{0});
      Tree tree;
      grow(std::move(all), options_.depth, odds, tree);
      trees.push_back(std::move(tree));
    }
    return {static_cast<float>(base), std::move(trees)};
  }

 private:
  struct Split {
    double gain = 1e-6;
    int feature = -1;
    std::size_t bin = 0;
  };

  double quality(const Derivatives& step) const {
    return step.slope * step.slope / (step.curvature + options_.regularization);
  }

  Split best_split(const std::vector<std::size_t>& members, const Derivatives& whole) const {
    Split best;
    for (std::size_t f = 0; f < bounds_.size(); ++f) {
      std::vector<Derivatives> by_bin(bounds_[f].size() + 1);
      for (const std::size_t i : members) by_bin[bins_[i][f]] += derivatives_[i];
      Derivatives left;
      for (std::size_t bin = 0; bin < bounds_[f].size(); ++bin) {
        left += by_bin[bin];
        const Derivatives right = whole - left;
        if (std::min(left.samples, right.samples) < options_.min_leaf) continue;
        const double gain = quality(left) + quality(right) - quality(whole);
        if (gain > best.gain) best = {gain, static_cast<int>(f), bin};
      }
    }
    return best;
  }

  void grow(std::vector<std::size_t> members, int depth, std::vector<double>& odds, Tree& tree) {
    const std::size_t here = tree.size();
    tree.emplace_back();
    Derivatives whole;
    for (const std::size_t i : members) whole += derivatives_[i];
    const Split split = depth > 0 ? best_split(members, whole) : Split{};
    if (split.feature < 0) {
      const double step = options_.rate * whole.slope / (whole.curvature + options_.regularization);
      tree[here].value = static_cast<float>(step);
      for (const std::size_t i : members) odds[i] += step;
      return;
    }
    const auto f = static_cast<std::size_t>(split.feature);
    const auto middle = std::stable_partition(
        members.begin(), members.end(), [&](std::size_t i) { return bins_[i][f] <= split.bin; });
    tree[here].feature = split.feature;
    tree[here].value = static_cast<float>(bounds_[f][split.bin]);
    grow({members.begin(), middle}, depth - 1, odds, tree);
    tree[here].upper = static_cast<std::int32_t>(tree.size() - here);
    grow({middle, members.end()}, depth - 1, odds, tree);
  }

  const std::vector<Sample>& samples_;
  const BoostingOptions& options_;
  std::vector<Derivatives> derivatives_;
  std::vector<std::vector<double>> bounds_;
  std::vector<std::vector<std::uint8_t>> bins_;
};

}  // namespace

TreeModel fit_model(const TrainingSet& set, const BoostingOptions& options) {
  if (set.samples.empty()) throw InputError("samples", "at least one", "none");
  auto [base, trees] = Booster(set.samples, options).fit();
  return {set.name, set.features, base, trees, set.origin};
}

}  // namespace symscene::bench
