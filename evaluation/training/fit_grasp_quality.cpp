// Fits the offset and slope of src/grasping/quality.cpp to the outcomes of grasps in physics, and
// prints them (evaluation/training/README.md).
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "grasp_outcomes.hpp"
#include "grasping/quality.hpp"
#include "logistic_fit.hpp"

namespace symscene::bench {
namespace {

constexpr std::size_t folds = 5;
constexpr double prior_precision = 1e-3;  // all but none

/// The inputs are 1 and the score.
LogisticData data_of(const std::vector<GraspSample>& samples) {
  const auto rows = static_cast<Eigen::Index>(samples.size());
  LogisticData data{Eigen::MatrixXd(rows, 2), Eigen::VectorXd(rows)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const GraspSample& sample = samples[static_cast<std::size_t>(i)];
    data.inputs.row(i) << 1.0, quality_score(sample.grasp);
    data.success[i] = sample.success ? 1.0 : 0.0;
  }
  return data;
}

/// Offset and slope of the score.
Eigen::VectorXd fitted(const std::vector<GraspSample>& samples) {
  return fit_logistic(data_of(samples), Eigen::Vector2d(0.0, 1.0), prior_precision);
}

/// The log-odds of every sample by a fit to the rounds of the other folds.
Eigen::VectorXd cross_validated(const std::vector<GraspSample>& samples) {
  const LogisticData all = data_of(samples);
  Eigen::VectorXd log_odds(all.success.size());
  for (std::size_t fold = 0; fold < folds; ++fold) {
    std::vector<GraspSample> others;
    for (const GraspSample& sample : samples) {
      if (sample.group % folds != fold) others.push_back(sample);
    }
    const Eigen::VectorXd weights = fitted(others);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (samples[i].group % folds == fold) log_odds[row] = all.inputs.row(row).dot(weights);
    }
  }
  return log_odds;
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

void print_quality_of(const std::string& what, const std::vector<GraspSample>& samples,
                      const Eigen::VectorXd& log_odds) {
  const double loss = log_loss({log_odds, data_of(samples).success}, Eigen::VectorXd::Ones(1));
  fmt::print("\n{}: log loss {:.4f}\n\n", what, loss);
  print_reliability(samples, log_odds);
}

void fit(const std::vector<std::filesystem::path>& files) {
  const std::vector<GraspSample> samples = read_grasp_samples(files);
  const LogisticData data = data_of(samples);
  fmt::print("{} grasps, {:.0f} succeeded\n", samples.size(), data.success.sum());
  print_quality_of("The score as log-odds", samples, data.inputs.col(1));
  print_quality_of(fmt::format("Fitted, {} folds of rounds", folds), samples,
                   cross_validated(samples));
  const Eigen::VectorXd weights = fitted(samples);
  fmt::print("\noffset {:.3f}, slope {:.3f}\n", weights[0], weights[1]);
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
