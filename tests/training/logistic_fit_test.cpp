#include "training/logistic_fit.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace symscene::bench {
namespace {

/// Outcomes of the logistic model with these weights at uniform inputs.
LogisticData outcomes_of(const Eigen::VectorXd& weights, Eigen::Index rows) {
  Random random(3);
  LogisticData data{Eigen::MatrixXd::Ones(rows, weights.size()), Eigen::VectorXd(rows)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index k = 1; k < weights.size(); ++k) data.inputs(i, k) = random.uniform(0.0, 1.0);
    const double p = 1.0 / (1.0 + std::exp(-data.inputs.row(i).dot(weights)));
    data.success[i] = random.uniform(0.0, 1.0) < p ? 1.0 : 0.0;
  }
  return data;
}

TEST(LogisticFit, FindsTheWeightsThatMadeTheOutcomes) {
  const Eigen::Vector3d weights(-1.0, 3.0, -2.0);
  const LogisticData data = outcomes_of(weights, 20000);
  const Eigen::VectorXd fitted = fit_logistic(data, Eigen::Vector3d::Zero(), 1e-3);
  EXPECT_LT((fitted - weights).norm(), 0.2) << fitted.transpose();
  EXPECT_LE(log_loss(data, fitted), log_loss(data, weights));
}

TEST(LogisticFit, AStrongPriorKeepsAllWeightsButTheBias) {
  const LogisticData data = outcomes_of(Eigen::Vector3d(-1.0, 3.0, -2.0), 500);
  const Eigen::Vector3d prior(5.0, 1.0, 1.0);
  const Eigen::VectorXd fitted = fit_logistic(data, prior, 1e9);
  EXPECT_LT((fitted - prior).tail(2).norm(), 1e-6);
  EXPECT_LT(fitted[0], 1.0);
}

TEST(LogisticFit, PredictsTheShareOfSuccesses) {
  const LogisticData data = outcomes_of(Eigen::Vector3d(1.0, 1.0, -2.0), 300);
  const Eigen::VectorXd fitted = fit_logistic(data, Eigen::Vector3d::Zero(), 1.0);
  const Eigen::ArrayXd p = 1.0 / (1.0 + (-(data.inputs * fitted).array()).exp());
  EXPECT_NEAR(p.mean(), data.success.mean(), 1e-4);
}

TEST(LogisticFit, OutcomesThatAlwaysSucceedGiveFiniteWeights) {
  LogisticData data = outcomes_of(Eigen::Vector3d(1.0, 1.0, -2.0), 50);
  data.success.setOnes();
  EXPECT_TRUE(fit_logistic(data, Eigen::Vector3d(1.0, 1.0, 1.0), 1.0).allFinite());
}

}  // namespace
}  // namespace symscene::bench
