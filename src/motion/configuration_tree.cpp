#include "configuration_tree.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace symscene {

std::size_t ConfigurationTree::add(const Eigen::VectorXd& positions, std::size_t parent) {
  nodes_.push_back({positions, parent});
  return nodes_.size() - 1;
}

std::size_t ConfigurationTree::nearest(const Eigen::VectorXd& positions) const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    double squared = 0.0;
    for (Eigen::Index i = 0; i < positions.size() && squared < least; ++i) {
      double way = positions[i] - nodes_[node].positions[i];
      if (space_.continuous[static_cast<std::size_t>(i)])
        way = std::remainder(way, 2.0 * std::numbers::pi);
      squared += way * way;
    }
    if (squared >= least) continue;
    least = squared;
    best = node;
  }
  return best;
}

std::vector<std::size_t> ConfigurationTree::to_root(std::size_t node) const {
  std::vector<std::size_t> way;
  for (; node != none; node = nodes_[node].parent) way.push_back(node);
  return way;
}

}  // namespace symscene
