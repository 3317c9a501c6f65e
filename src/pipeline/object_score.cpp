#include "symscene/pipeline/object_score.hpp"

#include "pipeline/tree_table.hpp"

namespace symscene {
namespace {

#include "pipeline/object_score_trees.inc"

constexpr std::size_t all_count = ObjectMeasures::count + ProposalContext::count;
constexpr TreeTable alone{object_alone_base, object_alone_roots, object_alone_nodes};
constexpr TreeTable among_others{object_among_others_base, object_among_others_roots,
                                 object_among_others_nodes};
static_assert(alone.asks_for_at_most(ObjectMeasures::count) &&
                  among_others.asks_for_at_most(all_count),
              "the trees were fitted to other measures");

}  // namespace

double estimated_probability(const ObjectMeasures& measures) {
  return alone.probability(values_of(measures));
}

double estimated_probability(const ObjectMeasures& measures, const ProposalContext& context) {
  return among_others.probability(values_of(measures, context));
}

}  // namespace symscene
