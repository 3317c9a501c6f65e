#pragma once

#include "symscene/occupancy/distance_field.hpp"
#include "symscene/proposals/proposals.hpp"

namespace symscene {

/// How well a proposal's points agree with the symmetries of its hypotheses; the fields are those
/// of OwnFeatures.
struct SymmetryFit {
  double axes = 0.0;
  double axis_misfit = 1.0;
  double axis_occlusion = 1.0;
  double planes = 0.0;
  double plane_inlier = 0.0;
  double plane_occlusion = 1.0;
};

SymmetryFit symmetry_fit(const MergedHypothesis& merged, const PointCloud& cloud,
                         const DistanceField& field, const ProposalOptions& options);

}  // namespace symscene
