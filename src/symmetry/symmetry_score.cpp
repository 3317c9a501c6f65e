#include "symmetry_score.hpp"

#include "core/boosted_trees.hpp"

namespace symscene {
namespace {

#include "axis_score_trees.inc"
#include "plane_score_trees.inc"

constexpr TreeTable of_axes{axis_score_base, axis_score_roots, axis_score_nodes};
constexpr TreeTable of_planes{plane_score_base, plane_score_roots, plane_score_nodes};
static_assert(of_axes.asks_for_at_most(AxisFeatures::count) &&
                  of_planes.asks_for_at_most(PlaneFeatures::count),
              "the trees were fitted to other measures");

}  // namespace

double axis_probability(const AxisFeatures& features) {
  return of_axes.probability(values_of(features));
}

double plane_probability(const PlaneFeatures& features) {
  return of_planes.probability(values_of(features));
}

}  // namespace symscene
