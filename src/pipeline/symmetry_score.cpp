#include "symscene/pipeline/symmetry_score.hpp"

#include "pipeline/tree_table.hpp"

namespace symscene {
namespace {

#include "pipeline/axis_score_trees.inc"
#include "pipeline/plane_score_trees.inc"

constexpr TreeTable of_axes{axis_score_base, axis_score_roots, axis_score_nodes};
constexpr TreeTable of_planes{plane_score_base, plane_score_roots, plane_score_nodes};
static_assert(of_axes.asks_for_at_most(AxisMeasures::count) &&
                  of_planes.asks_for_at_most(PlaneMeasures::count),
              "the trees were fitted to other measures");

}  // namespace

double axis_probability(const AxisMeasures& measures) {
  return of_axes.probability(values_of(measures));
}

double plane_probability(const PlaneMeasures& measures) {
  return of_planes.probability(values_of(measures));
}

}  // namespace symscene
