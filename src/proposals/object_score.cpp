#include "object_score.hpp"

#include "core/boosted_trees.hpp"

namespace symscene {
namespace {

#include "object_score_trees.inc"

constexpr std::size_t all_count = ObjectFeatures::count + ProposalContext::count;
constexpr TreeTable alone{object_alone_base, object_alone_roots, object_alone_nodes};
constexpr TreeTable among_others{object_among_others_base, object_among_others_roots,
                                 object_among_others_nodes};
static_assert(alone.asks_for_at_most(ObjectFeatures::count) &&
                  among_others.asks_for_at_most(all_count),
              "the trees were fitted to other measures");

}  // namespace

double estimated_probability(const ObjectFeatures& features) {
  return alone.probability(values_of(features));
}

double estimated_probability(const ObjectFeatures& features, const ProposalContext& context) {
  return among_others.probability(values_of(features, context));
}

}  // namespace symscene
