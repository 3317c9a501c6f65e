// Fits the weights of src/grasping/quality.cpp to the outcomes of grasps in physics, and prints
// them (evaluation/training/README.md).
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <exception>
#include <limits>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grasp_outcomes.hpp"
#include "grasping/quality.hpp"
#include "logistic_fit.hpp"

namespace symscene::bench {
namespace {

constexpr std::size_t folds = 5;

LogisticData data_of(const std::vector<GraspSample>& samples) {
  const auto rows = static_cast<Eigen::Index>(samples.size());
  LogisticData data{Eigen::MatrixXd(rows, QualityVector::RowsAtCompileTime), Eigen::VectorXd(rows)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const GraspSample& sample = samples[static_cast<std::size_t>(i)];
    data.success[i] = sample.success ? 1.0 : 0.0;
    data.inputs.row(i) = quality_inputs(sample.grasp).transpose();
  }
  return data;
}

/// The log-odds of every sample by a fit to the rounds of the other folds.
Eigen::VectorXd cross_validated(const std::vector<GraspSample>& samples, double precision) {
  Eigen::VectorXd log_odds(static_cast<Eigen::Index>(samples.size()));
  const LogisticData all = data_of(samples);
  for (std::size_t fold = 0; fold < folds; ++fold) {
    std::vector<GraspSample> others;
    for (const GraspSample& sample : samples) {
      if (sample.group % folds != fold) others.push_back(sample);
    }
    const Eigen::VectorXd weights =
        fit_logistic(data_of(others), prior_quality_weights(), precision);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (samples[i].group % folds == fold) log_odds[row] = all.inputs.row(row).dot(weights);
    }
  }
  return log_odds;
}

double loss_of(const std::vector<GraspSample>& samples, const Eigen::VectorXd& log_odds) {
  LogisticData data{log_odds, data_of(samples).success};
  return log_loss(data, Eigen::VectorXd::Ones(1));
}

void print_reliability(const std::vector<GraspSample>& samples, const Eigen::VectorXd& log_odds) {
  constexpr std::array bounds{0.0, 0.4, 0.6, 0.7, 0.8, 0.9, 0.95, 1.0};
  fmt::print("| predicted | grasps | mean prediction | succeeded |\n| --- | --- | --- | --- |\n");
  for (std::size_t bin = 0; bin + 1 < bounds.size(); ++bin) {
    double predicted = 0.0, succeeded = 0.0, count = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double p = logistic(log_odds[static_cast<Eigen::Index>(i)]);
      if (p < bounds[bin] || p >= bounds[bin + 1]) continue;
      predicted += p;
      succeeded += samples[i].success ? 1.0 : 0.0;
      count += 1.0;
    }
    if (count == 0.0) continue;
    fmt::print("| {} to {} | {:.0f} | {:.2f} | {:.2f} |\n", bounds[bin], bounds[bin + 1], count,
               predicted / count, succeeded / count);
  }
}

double best_precision(const std::vector<GraspSample>& samples) {
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  for (const double precision : {0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 1000.0}) {
    const double loss = loss_of(samples, cross_validated(samples, precision));
    fmt::print("precision of the prior {:6}: log loss {:.4f}\n", precision, loss);
    if (loss < least) std::tie(least, best) = std::tuple(loss, precision);
  }
  return best;
}

void fit(const std::vector<std::filesystem::path>& files) {
  const std::vector<GraspSample> samples = read_grasp_samples(files);
  const LogisticData data = data_of(samples);
  fmt::print("{} grasps, {:.0f} succeeded\n", samples.size(), data.success.sum());
  const Eigen::VectorXd by_hand = data.inputs * prior_quality_weights();
  fmt::print("weights by hand: log loss {:.4f}\n", loss_of(samples, by_hand));
  print_reliability(samples, by_hand);
  const double precision = best_precision(samples);
  fmt::print("fitted, {} folds of rounds, precision {}:\n", folds, precision);
  print_reliability(samples, cross_validated(samples, precision));
  const Eigen::VectorXd weights = fit_logistic(data, prior_quality_weights(), precision);
  fmt::print("weights: {}\n", fmt::join(weights, ", "));
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  CLI::App app("Fits the quality of grasps to outcomes of symscene_bench_clutter --attempts");
  std::vector<std::filesystem::path> files;
  app.add_option("attempts", files, "CSV files")->required()->check(CLI::ExistingFile);
  CLI11_PARSE(app, argc, argv);
  try {
    symscene::bench::fit(files);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "symscene_fit_grasp_quality: %s\n", error.what());
    return 1;
  }
}
