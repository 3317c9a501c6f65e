#include "symscene/pipeline/plane_score.hpp"

#include "pipeline/tree_table.hpp"

namespace symscene {
namespace {

#include "pipeline/plane_score_trees.inc"

constexpr TreeTable trees{plane_score_base, plane_score_roots, plane_score_nodes};
static_assert(trees.asks_for_at_most(PlaneMeasures::count),
              "the trees were fitted to other measures");

}  // namespace

double plane_probability(const PlaneMeasures& measures) {
  return trees.probability(measures.values());
}

}  // namespace symscene
