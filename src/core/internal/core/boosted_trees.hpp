#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace symscene {

/// The values of some measures, one kind after the other, in the order of their fields.
template <class... Measures>
std::array<double, (Measures::count + ...)> values_of(const Measures&... measures) {
  std::array<double, (Measures::count + ...)> values{};
  std::size_t next = 0;
  const auto append = [&](const char*, double value) { values.at(next++) = value; };
  (Measures::visit_fields(measures, append), ...);
  return values;
}

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
