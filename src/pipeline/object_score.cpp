#include "symscene/pipeline/object_score.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace symscene {
namespace {

/// A node of a tree: a question with what follows for an answer of at most the bound (the next
/// node) and above it, or a leaf that adds to the log-odds.
struct TreeNode {
  std::int16_t measure;  ///< number of the measure that is asked for; leaf below 0
  std::int16_t above;    ///< nodes to go on to where the measure is above the bound
  float value;           ///< bound, or what a leaf adds
};

#include "pipeline/object_score_trees.inc"

static_assert(std::all_of(std::begin(object_score_nodes), std::end(object_score_nodes),
                          [](const TreeNode& node) {
                            return node.measure < static_cast<int>(ObjectMeasures::count);
                          }),
              "the trees were fitted to other measures");

}  // namespace

double estimated_probability(const ObjectMeasures& measures) {
  const auto values = measures.values();
  double log_odds = double{object_score_base};
  for (const std::int32_t root : object_score_roots) {
    const TreeNode* node = object_score_nodes + root;
    while (node->measure >= 0) {
      const auto value = static_cast<float>(values[static_cast<std::size_t>(node->measure)]);
      node += value > node->value ? node->above : 1;
    }
    log_odds += double{node->value};
  }
  return 1.0 / (1.0 + std::exp(-log_odds));
}

double object_score(const ObjectMeasures& measures) {
  return combined_score(estimated_probability(measures), measures.confidence);
}

}  // namespace symscene
