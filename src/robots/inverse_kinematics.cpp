#include "symscene/robots/inverse_kinematics.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "core/random.hpp"
#include "pose_solver.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

void require_valid(const ArmChain& chain, const Eigen::Isometry3d& T_base_tip,
                   const Eigen::VectorXd& reference, const InverseKinematicsOptions& options) {
  options.validate();
  if (!T_base_tip.matrix().allFinite())
    throw InputError("pose of the tip", "finite numbers", "others");
  if (reference.size() != static_cast<Eigen::Index>(chain.joints.size()) || !reference.allFinite())
    throw InputError("reference", fmt::format("{} finite joint positions", chain.joints.size()),
                     fmt::format("{} numbers", reference.size()));
}

/// The reference first, then random positions; each start has a stream of its own.
ChainVector start_positions(const PoseSolver& solver, const ChainVector& reference, int start,
                            std::uint64_t seed) {
  if (start == 0) return reference.cwiseMax(solver.lower()).cwiseMin(solver.upper());
  Random random(seed, static_cast<std::uint64_t>(start));
  constexpr double pi = std::numbers::pi;
  ChainVector q(reference.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const bool bounded = std::isfinite(solver.upper()[i]);
    q[i] = random.uniform(bounded ? solver.lower()[i] : -pi, bounded ? solver.upper()[i] : pi);
  }
  return q;
}

/// Keeps the positions if they are better than those of the result: converged, then nearer.
void keep_better(InverseKinematicsResult& result, const PoseSolver& solver, const ChainVector& q,
                 bool converged, double& least) {
  const double position = solver.position_error(q), rotation = solver.rotation_error(q);
  const double error = converged ? -1.0 : position + rotation;
  if (!(error < least)) return;
  least = error;
  result.status =
      converged ? InverseKinematicsStatus::converged : InverseKinematicsStatus::not_reached;
  result.positions = q;
  result.position_error = position;
  result.rotation_error = rotation;
}

InverseKinematicsResult search(const ArmChain& chain, const Eigen::Isometry3d& T_base_tip,
                               bool orientation, const Eigen::VectorXd& reference,
                               const InverseKinematicsOptions& options) {
  require_valid(chain, T_base_tip, reference, options);
  PoseSolver solver(chain, T_base_tip, orientation, options);
  InverseKinematicsResult result;
  double least = std::numeric_limits<double>::infinity();
  for (int start = 0; start < options.max_starts && !result.converged(); ++start) {
    ChainVector q = start_positions(solver, reference, start, options.seed);
    const bool converged = solver.solve(q);
    if (converged) solver.refine(q, reference);
    keep_better(result, solver, solver.within_limits(q), converged, least);
    result.starts = start + 1;
    if (q.size() == 0) break;
  }
  result.iterations = solver.iterations();
  return result;
}

}  // namespace

Eigen::VectorXd middle_of_limits(const ArmChain& chain) {
  Eigen::VectorXd middle(static_cast<Eigen::Index>(chain.joints.size()));
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    middle[static_cast<Eigen::Index>(i)] = 0.5 * (chain.joints[i].lower + chain.joints[i].upper);
  return middle;
}

InverseKinematicsResult inverse_kinematics(const ArmChain& chain,
                                           const Eigen::Isometry3d& T_base_tip,
                                           const Eigen::VectorXd& reference,
                                           const InverseKinematicsOptions& options) {
  return search(chain, T_base_tip, true, reference, options);
}

InverseKinematicsResult inverse_kinematics(const ArmChain& chain,
                                           const Eigen::Isometry3d& T_base_tip,
                                           const InverseKinematicsOptions& options) {
  return search(chain, T_base_tip, true, middle_of_limits(chain), options);
}

std::vector<Eigen::VectorXd> inverse_kinematics_solutions(const ArmChain& chain,
                                                          const Eigen::Isometry3d& T_base_tip,
                                                          const Eigen::VectorXd& reference,
                                                          std::size_t count,
                                                          const InverseKinematicsOptions& options) {
  require_valid(chain, T_base_tip, reference, options);
  PoseSolver solver(chain, T_base_tip, true, options);
  std::vector<Eigen::VectorXd> solutions;
  for (int start = 0; start < options.max_starts && solutions.size() < count; ++start) {
    ChainVector q = start_positions(solver, reference, start, options.seed);
    if (!solver.solve(q)) continue;
    const Eigen::VectorXd found = solver.within_limits(q);
    const bool repeats = std::any_of(solutions.begin(), solutions.end(), [&](const auto& other) {
      return found.size() == 0 || (found - other).cwiseAbs().maxCoeff() < options.distinct;
    });
    if (!repeats) solutions.push_back(found);
  }
  std::stable_sort(solutions.begin(), solutions.end(), [&](const auto& a, const auto& b) {
    return solver.distance(a, reference) < solver.distance(b, reference);
  });
  return solutions;
}

InverseKinematicsResult inverse_kinematics_of_point(const ArmChain& chain,
                                                    const Eigen::Vector3d& point_base,
                                                    const Eigen::VectorXd& reference,
                                                    const InverseKinematicsOptions& options) {
  const Eigen::Isometry3d T_base_tip(Eigen::Translation3d{point_base});
  return search(chain, T_base_tip, false, reference, options);
}

}  // namespace symscene
