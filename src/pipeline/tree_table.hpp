#pragma once

#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>

namespace symscene {

/// A node of a tree: a question with what follows for an answer of at most the bound (the next
/// node) and above it, or a leaf that adds to the log-odds.
struct TreeNode {
  std::int16_t measure;  ///< number of the measure that is asked for; leaf below 0
  std::int16_t above;    ///< nodes to go on to where the measure is above the bound
  float value;           ///< bound, or what a leaf adds
};

/// A probability as boosted trees estimate it (Friedman 2001), in the form that the programs which
/// fit them write.
struct TreeTable {
  float base;                           ///< log-odds before any tree
  std::span<const std::int32_t> roots;  ///< first node of every tree
  std::span<const TreeNode> nodes;

  double probability(std::span<const double> measures) const {
    double log_odds = double{base};
    for (const std::int32_t root : roots) {
      const TreeNode* node = &nodes[static_cast<std::size_t>(root)];
      while (node->measure >= 0) {
        const auto value = static_cast<float>(measures[static_cast<std::size_t>(node->measure)]);
        node += value > node->value ? node->above : 1;
      }
      log_odds += double{node->value};
    }
    return 1.0 / (1.0 + std::exp(-log_odds));
  }

  /// Whether no tree asks for more than so many measures.
  constexpr bool asks_for_at_most(std::size_t measures) const {
    for (const TreeNode& node : nodes) {
      if (node.measure >= static_cast<int>(measures)) return false;
    }
    return true;
  }
};

}  // namespace symscene
