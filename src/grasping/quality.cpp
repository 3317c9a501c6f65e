#include "grasping/quality.hpp"

#include <array>
#include <cmath>

#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

/// A feature, and the bounds that are mapped to 0 and 1.
struct Input {
  double GraspFeatures::*feature;
  double low;
  double high;
};

constexpr std::array<Input, 12> inputs{{
    {&GraspFeatures::cone_margin, 0.0, 0.5},
    {&GraspFeatures::cone_share, 0.5, 1.0},
    {&GraspFeatures::contact_area, 0.0, 0.3},
    {&GraspFeatures::depth, 0.0, 0.02},
    {&GraspFeatures::opening_margin, 0.0, 0.01},
    {&GraspFeatures::lever_arm, 0.0, 0.05},
    {&GraspFeatures::torque_ratio, 0.0, 1.0},
    {&GraspFeatures::clearance, 0.0, 0.01},
    {&GraspFeatures::own_clearance, 0.0, 0.01},
    {&GraspFeatures::depth_tolerance, 0.0, 0.04},
    {&GraspFeatures::observed, 0.0, 1.0},
    {&GraspFeatures::tilt, 0.5, 1.6},
}};

}  // namespace

QualityVector quality_inputs(const Grasp& grasp) {
  QualityVector values;
  values[0] = 1.0;
  // A symmetry places the hidden contact better.
  values[1] = grasp.source == GraspSource::antipodal ? 0.0 : 1.0;
  Eigen::Index next = 2;
  for (const auto& [feature, low, high] : inputs)
    values[next++] = ramp(grasp.features.*feature, low, high);
  return values;
}

QualityVector prior_quality_weights() {
  return {-3.5, 0.5, 1.5, 1.0, 1.0, 0.5, 0.5, -1.0, -0.5, 1.0, 0.7, 1.5, 0.5, -0.3};
}

QualityVector quality_weights() { return prior_quality_weights(); }

double logistic(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

double success_probability(const Grasp& grasp) {
  return logistic(quality_inputs(grasp).dot(quality_weights()));
}

}  // namespace symscene
