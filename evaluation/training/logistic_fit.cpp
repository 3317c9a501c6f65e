#include "logistic_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace symscene::bench {
namespace {

Eigen::VectorXd probabilities(const LogisticData& data, const Eigen::VectorXd& weights) {
  return (1.0 + (-(data.inputs * weights).array()).exp()).inverse().matrix();
}

/// The negative logarithm of the posterior, up to a constant.
class Posterior {
 public:
  Posterior(const LogisticData& data, const Eigen::VectorXd& prior, double precision)
      : data_(data),
        prior_(prior),
        precisions_(Eigen::VectorXd::Constant(prior.size(), precision)) {
    constexpr double of_first = 1e-6;
    precisions_[0] = of_first;
  }

  double value(const Eigen::VectorXd& weights) const {
    const double rows = static_cast<double>(data_.success.size());
    return rows * log_loss(data_, weights) + 0.5 * (weights - prior_).cwiseAbs2().dot(precisions_);
  }
  Eigen::VectorXd newton_step(const Eigen::VectorXd& weights) const {
    const Eigen::VectorXd p = probabilities(data_, weights);
    const Eigen::VectorXd gradient =
        data_.inputs.transpose() * (p - data_.success) + precisions_.cwiseProduct(weights - prior_);
    const Eigen::VectorXd spread = p.cwiseProduct((1.0 - p.array()).matrix());
    Eigen::MatrixXd hessian = data_.inputs.transpose() * spread.asDiagonal() * data_.inputs;
    hessian.diagonal() += precisions_;
    return -hessian.ldlt().solve(gradient);
  }

 private:
  const LogisticData& data_;
  const Eigen::VectorXd& prior_;
  Eigen::VectorXd precisions_;
};

}  // namespace

Eigen::VectorXd fit_logistic(const LogisticData& data, const Eigen::VectorXd& prior,
                             double precision) {
  constexpr int max_steps = 100;
  constexpr double tolerance = 1e-9, least_share = 1e-6;
  const Posterior posterior(data, prior, precision);
  Eigen::VectorXd weights = prior;
  for (int step = 0; step < max_steps; ++step) {
    const Eigen::VectorXd change = posterior.newton_step(weights);
    const double before = posterior.value(weights);
    double share = 1.0;  // of a step that overshoots
    while (share > least_share && !(posterior.value(weights + share * change) < before))
      share /= 2.0;
    if (share <= least_share) break;
    weights += share * change;
    if (change.norm() < tolerance) break;
  }
  return weights;
}

double log_loss(const LogisticData& data, const Eigen::VectorXd& weights) {
  const Eigen::VectorXd p = probabilities(data, weights);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < p.size(); ++i)
    sum -= std::log(std::max(1e-12, data.success[i] > 0.5 ? p[i] : 1.0 - p[i]));
  return sum / static_cast<double>(p.size());
}

}  // namespace symscene::bench
