#include "grasping/quality.hpp"

#include <array>
#include <cmath>

#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

/// A feature, mapped linearly from the bounds beyond which it no longer matters to [0, 1], and its
/// weight.
struct Term {
  double GraspFeatures::*feature;
  double low;
  double high;
  double weight;
};

constexpr double bias = -3.5;
constexpr double symmetry_weight = 0.5;  // a symmetry places the hidden contact better
constexpr std::array<Term, 12> terms{{
    {&GraspFeatures::cone_margin, 0.0, 0.5, 1.5},
    {&GraspFeatures::cone_share, 0.5, 1.0, 1.0},
    {&GraspFeatures::contact_area, 0.0, 0.3, 1.0},
    {&GraspFeatures::depth, 0.0, 0.02, 0.5},
    {&GraspFeatures::opening_margin, 0.0, 0.01, 0.5},
    {&GraspFeatures::lever_arm, 0.0, 0.05, -1.0},
    {&GraspFeatures::torque_ratio, 0.0, 1.0, -0.5},
    {&GraspFeatures::clearance, 0.0, 0.01, 1.0},
    {&GraspFeatures::own_clearance, 0.0, 0.01, 0.7},
    {&GraspFeatures::depth_tolerance, 0.0, 0.04, 1.5},
    {&GraspFeatures::observed, 0.0, 1.0, 0.5},
    {&GraspFeatures::tilt, 0.5, 1.6, -0.3},
}};

// Printed by symscene_fit_grasp_quality (evaluation/training/README.md).
constexpr double fitted_offset = 1.598;
constexpr double fitted_slope = 0.407;

}  // namespace

double quality_score(const Grasp& grasp) {
  double sum = bias;
  if (grasp.source != GraspSource::antipodal) sum += symmetry_weight;
  for (const Term& term : terms)
    sum += term.weight * ramp(grasp.features.*term.feature, term.low, term.high);
  return sum;
}

double logistic(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

double success_probability(const Grasp& grasp) {
  return logistic(fitted_offset + (fitted_slope * quality_score(grasp)));
}

}  // namespace symscene
