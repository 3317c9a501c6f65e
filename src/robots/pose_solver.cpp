#include "pose_solver.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>

namespace symscene {
namespace {

/// Keeps the normal equations solvable at a singular configuration.
constexpr double least_damping = 1e-12;
/// A start is given up where this many steps do not halve the error.
constexpr int patience = 8;

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

}  // namespace

PoseSolver::PoseSolver(const ArmChain& chain, const Eigen::Isometry3d& T_base_tip, bool orientation,
                       const InverseKinematicsOptions& options)
    : chain_(chain), T_base_tip_(T_base_tip), options_(options), orientation_(orientation) {
  // Metres count relative to the arm's length, as angles count relative to a radian.
  if (const double length = chain.length(); length > 0.0) per_metre_ = 1.0 / length;
  const auto size = static_cast<Eigen::Index>(chain.joints.size());
  lower_.resize(size);
  upper_.resize(size);
  range_.resize(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const ChainJoint& joint = chain.joints[static_cast<std::size_t>(i)];
    const bool turns = joint.kind != JointKind::prismatic;
    const bool bounded = !turns || (options.limits && joint.kind != JointKind::continuous);
    lower_[i] = bounded ? joint.lower : -std::numeric_limits<double>::infinity();
    upper_[i] = bounded ? joint.upper : std::numeric_limits<double>::infinity();
    range_[i] = bounded ? joint.upper - joint.lower : 2.0 * std::numbers::pi;
  }
}

void PoseSolver::evaluate(const ChainVector& q) {
  const Eigen::Isometry3d T = tip_and_jacobian(chain_, q, J_);
  error_.head<3>() = rotation_vector(T_base_tip_.linear() * T.linear().transpose());
  error_.tail<3>() = per_metre_ * (T_base_tip_.translation() - T.translation());
  J_.bottomRows<3>() *= per_metre_;
  if (orientation_) return;
  error_.head<3>().setZero();
  J_.topRows<3>().setZero();
}

bool PoseSolver::reached() const {
  return error_.head<3>().norm() <= options_.rotation_tolerance &&
         error_.tail<3>().norm() <= per_metre_ * options_.position_tolerance;
}

ChainVector PoseSolver::step(const ChainVector& q, const ChainVector& drift) const {
  const Eigen::Index size = q.size();
  // Sugihara 2011, equation 19: the damping follows the squared error.
  const double damping = 0.5 * options_.damping * error_.squaredNorm() + least_damping;
  std::array<bool, max_arm_joints> fixed{};
  ChainVector change = drift;
  // Joints that would leave their range are fixed at its bound, and the others solve for the rest.
  for (Eigen::Index pass = 0; pass <= size; ++pass) {
    Matrix6d A = damping * Matrix6d::Identity();
    Vector6d rest = error_;
    for (Eigen::Index i = 0; i < size; ++i) {
      if (!fixed[static_cast<std::size_t>(i)]) {
        A.noalias() += range_[i] * range_[i] * J_.col(i) * J_.col(i).transpose();
        change[i] = drift[i];
      }
      rest -= change[i] * J_.col(i);
    }
    const Vector6d y = A.ldlt().solve(rest);
    bool leaves = false;
    for (Eigen::Index i = 0; i < size; ++i) {
      if (fixed[static_cast<std::size_t>(i)]) continue;
      const double wanted = change[i] + range_[i] * range_[i] * J_.col(i).dot(y);
      change[i] = std::clamp(wanted, lower_[i] - q[i], upper_[i] - q[i]);
      fixed[static_cast<std::size_t>(i)] = change[i] != wanted;
      leaves |= change[i] != wanted;
    }
    if (!leaves) break;
  }
  const double greatest = size > 0 ? change.cwiseAbs().maxCoeff() : 0.0;
  return greatest > options_.max_step ? ChainVector(change * (options_.max_step / greatest))
                                      : change;
}

bool PoseSolver::solve(ChainVector& q) {
  const ChainVector none = ChainVector::Zero(q.size());
  double before = std::numeric_limits<double>::infinity();
  ChainVector best = q;
  double least = before;
  for (int i = 0;; ++i) {
    evaluate(q);
    if (reached()) return true;
    const double error = error_.norm();
    if (error < least) {
      least = error;
      best = q;
    }
    if (i % patience == patience - 1) {
      if (least > 0.5 * before) break;
      before = least;
    }
    if (i == options_.max_iterations || q.size() == 0) break;
    q += step(q, none);
    q = q.cwiseMax(lower_).cwiseMin(upper_);
    ++iterations_;
  }
  q = best;
  return false;
}

void PoseSolver::refine(ChainVector& q, const ChainVector& reference) {
  ChainVector moved = q;
  for (int i = 0; i < options_.refinements; ++i) {
    evaluate(moved);
    moved += step(moved, reference - moved);
    moved = moved.cwiseMax(lower_).cwiseMin(upper_);
    ++iterations_;
  }
  if (solve(moved) && distance(moved, reference) < distance(q, reference)) q = moved;
}

ChainVector PoseSolver::within_limits(ChainVector q) const {
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (!std::isfinite(upper_[i])) q[i] = std::remainder(q[i], 2.0 * std::numbers::pi);
  }
  return q;
}

double PoseSolver::distance(const ChainVector& a, const ChainVector& b) const {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (range_[i] > 0.0) sum += std::pow((a[i] - b[i]) / range_[i], 2);
  }
  return std::sqrt(sum);
}

double PoseSolver::position_error(const ChainVector& q) const {
  const Eigen::Isometry3d T = follow_chain(chain_, q, [](auto&&...) {});
  return (T_base_tip_.translation() - T.translation()).norm();
}

double PoseSolver::rotation_error(const ChainVector& q) const {
  if (!orientation_) return 0.0;
  const Eigen::Isometry3d T = follow_chain(chain_, q, [](auto&&...) {});
  return rotation_vector(T_base_tip_.linear() * T.linear().transpose()).norm();
}

}  // namespace symscene
