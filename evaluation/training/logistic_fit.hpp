#pragma once

#include <Eigen/Core>

namespace symscene::bench {

/// Outcomes and the values that they depend on. The first column of `inputs` is 1.
struct LogisticData {
  Eigen::MatrixXd inputs;   ///< N×K
  Eigen::VectorXd success;  ///< N, 0 or 1
};

/// Weights that maximise the likelihood of the outcomes times a Gaussian prior about `prior` with
/// the given precision, that of the first weight excepted. Newton's method (Bishop 2006, 4.3.3).
Eigen::VectorXd fit_logistic(const LogisticData& data, const Eigen::VectorXd& prior,
                             double precision);

/// The mean negative logarithm of the probabilities that weights give to the outcomes.
double log_loss(const LogisticData& data, const Eigen::VectorXd& weights);

}  // namespace symscene::bench
