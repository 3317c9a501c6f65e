#include "symscene/motion/rrt_connect.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "configuration_tree.hpp"
#include "core/random.hpp"
#include "path_shortcuts.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

void require_configuration(const JointSpace& space, const char* name,
                           const Eigen::VectorXd& positions) {
  if (positions.size() != space.size() || !positions.allFinite()) {
    throw InputError(name, fmt::format("{} finite numbers", space.size()),
                     fmt::format("{}", fmt::join(positions, ", ")));
  }
}

/// One search. Goals are turned so that the way to them from the start is the shortest.
class RrtConnect {
 public:
  RrtConnect(const JointSpace& space, const MotionValidity& validity,
             const RrtConnectOptions& options)
      : space_(space), validity_(validity), options_(options), random_(options.seed) {}

  PathResult run(const Eigen::VectorXd& start, const std::vector<Eigen::VectorXd>& goals) {
    PathResult result;
    result.obstacle = obstacle(start);
    const std::vector<std::size_t> valid = valid_goals(goals, result);
    if (result.status == PathStatus::no_path && !join_by_line(start, goals, valid, result))
      grow(start, goals, valid, result);
    if (result.status == PathStatus::found) {
      result.waypoints = shortened(
          std::move(result.waypoints),
          [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return is_free(a, b); },
          options_.shortcuts, random_);
    }
    result.checks = checks_;
    return result;
  }

 private:
  std::string obstacle(const Eigen::VectorXd& positions) {
    ++checks_;
    const Eigen::Index joint = space_.joint_outside(positions);
    if (joint >= 0) return fmt::format("joint {} outside its limits", joint);
    return validity_.obstacle(positions);
  }

  bool is_free(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
    ++checks_;
    if (validity_.is_free) return validity_.is_free(from, to);
    const double steps = std::max(1.0, std::ceil((to - from).norm() / options_.resolution));
    for (double i = 1.0; i < steps; i += 1.0) {
      ++checks_;
      if (!validity_.obstacle(from + i / steps * (to - from)).empty()) return false;
    }
    return true;
  }

  std::vector<std::size_t> valid_goals(const std::vector<Eigen::VectorXd>& goals,
                                       PathResult& result) {
    std::vector<std::size_t> valid;
    if (!result.obstacle.empty()) {
      result.status = PathStatus::invalid_start;
      return valid;
    }
    std::string of_first;
    for (std::size_t i = 0; i < goals.size(); ++i) {
      const std::string met = obstacle(goals[i]);
      if (met.empty()) valid.push_back(i);
      if (i == 0) of_first = met;
    }
    if (!valid.empty()) return valid;
    result.status = PathStatus::invalid_goal;
    result.obstacle = of_first;
    return valid;
  }

  bool join_by_line(const Eigen::VectorXd& start, const std::vector<Eigen::VectorXd>& goals,
                    std::vector<std::size_t> order, PathResult& result) {
    const auto way = [&](std::size_t i) { return space_.difference(start, goals[i]).norm(); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return way(a) < way(b); });
    for (const std::size_t i : order) {
      const Eigen::VectorXd goal = start + space_.difference(start, goals[i]);
      if (!is_free(start, goal)) continue;
      result.status = PathStatus::found;
      result.goal = i;
      result.waypoints = {start, goal};
      return true;
    }
    return false;
  }

  /// The node that `tree` reaches on one step from its nearest node; none if that step is blocked.
  std::optional<std::size_t> extend(ConfigurationTree& tree, std::size_t from,
                                    const Eigen::VectorXd& target) {
    const Eigen::VectorXd way = space_.difference(tree[from], target);
    const double share = std::min(1.0, options_.max_step / std::max(way.norm(), 1e-12));
    const Eigen::VectorXd next = tree[from] + share * way;
    if (space_.joint_outside(next) >= 0 || !obstacle(next).empty() || !is_free(tree[from], next))
      return std::nullopt;
    return tree.add(next, from);
  }

  /// The node of `tree` at the target, if straight steps lead there.
  std::optional<std::size_t> connect(ConfigurationTree& tree, const Eigen::VectorXd& target) {
    std::size_t node = tree.nearest(target);
    while (space_.difference(tree[node], target).norm() > 1e-9) {
      const auto next = extend(tree, node, target);
      if (!next) return std::nullopt;
      node = *next;
    }
    return node;
  }

  void grow(const Eigen::VectorXd& start, const std::vector<Eigen::VectorXd>& goals,
            const std::vector<std::size_t>& valid, PathResult& result) {
    ConfigurationTree from_start(space_);
    ConfigurationTree from_goals(space_);
    from_start.add_root(start);
    for (const std::size_t i : valid) from_goals.add_root(goals[i]);
    for (int i = 0; i < options_.max_iterations; ++i) {
      result.iterations = i + 1;
      const bool forwards = i % 2 == 0;
      ConfigurationTree& growing = forwards ? from_start : from_goals;
      ConfigurationTree& other = forwards ? from_goals : from_start;
      const Eigen::VectorXd target = space_.sample(random_);
      const auto node = extend(growing, growing.nearest(target), target);
      if (!node) continue;
      const auto met = connect(other, growing[*node]);
      if (!met) continue;
      join(from_start, forwards ? *node : *met, from_goals, forwards ? *met : *node, result);
      result.goal = valid[result.goal];
      return;
    }
  }

  /// The way through both trees, as steps from the start, so that no continuous joint jumps.
  void join(const ConfigurationTree& from_start, std::size_t start_node,
            const ConfigurationTree& from_goals, std::size_t goal_node, PathResult& result) const {
    const std::vector<std::size_t> back = from_start.to_root(start_node);
    for (auto i = back.rbegin(); i != back.rend(); ++i) result.waypoints.push_back(from_start[*i]);
    const std::vector<std::size_t> on = from_goals.to_root(goal_node);
    for (std::size_t i = 1; i < on.size(); ++i) {
      result.waypoints.emplace_back(result.waypoints.back() + from_goals[on[i]] -
                                    from_goals[on[i - 1]]);
    }
    result.goal = on.back();  // roots were added first, in the order of valid goals
    result.status = PathStatus::found;
  }

  const JointSpace& space_;
  const MotionValidity& validity_;
  const RrtConnectOptions& options_;
  Random random_;
  std::size_t checks_ = 0;
};

}  // namespace

const char* to_string(PathStatus status) {
  switch (status) {
    case PathStatus::found:
      return "found";
    case PathStatus::invalid_start:
      return "invalid_start";
    case PathStatus::invalid_goal:
      return "invalid_goal";
    case PathStatus::no_path:
      return "no_path";
  }
  return "";
}

PathResult rrt_connect(const JointSpace& space, const Eigen::VectorXd& start,
                       const std::vector<Eigen::VectorXd>& goals, const MotionValidity& validity,
                       const RrtConnectOptions& options) {
  options.validate();
  space.validate();
  require_configuration(space, "start", start);
  if (goals.empty()) throw InputError("goals", "at least one", "none");
  for (const Eigen::VectorXd& goal : goals) require_configuration(space, "goal", goal);
  return RrtConnect(space, validity, options).run(start, goals);
}

}  // namespace symscene
