#pragma once

#include <vector>

#include "symscene/motion/joint_space.hpp"

namespace symscene {

/// A tree of configurations that valid straight motions connect. It may have several roots.
class ConfigurationTree {
 public:
  explicit ConfigurationTree(const JointSpace& space) : space_(space) {}

  std::size_t add_root(const Eigen::VectorXd& positions) { return add(positions, none); }
  std::size_t add(const Eigen::VectorXd& positions, std::size_t parent);
  const Eigen::VectorXd& operator[](std::size_t node) const { return nodes_[node].positions; }
  /// The node with the shortest way to a configuration.
  std::size_t nearest(const Eigen::VectorXd& positions) const;
  /// The nodes from one to its root, itself and the root included.
  std::vector<std::size_t> to_root(std::size_t node) const;

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct Node {
    Eigen::VectorXd positions;
    std::size_t parent;
  };

  const JointSpace& space_;
  std::vector<Node> nodes_;
};

}  // namespace symscene
