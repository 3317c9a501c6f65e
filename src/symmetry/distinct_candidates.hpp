#pragma once

#include "symscene/symmetry/reflectional_detection.hpp"

namespace symscene {

/// When the planes of two candidates are one.
struct EqualPlanes {
  double angle;                 ///< [rad]
  double distance;              ///< at the support of the later one [m]
  double max_support_distance;  ///< between the centroids of their supports [m]
};

/// The candidates in their order, without those whose plane repeats that of one kept before.
std::vector<ReflectionalCandidate> distinct_candidates(
    std::vector<ReflectionalCandidate> candidates, const PointCloud& cloud,
    const EqualPlanes& equal);

/// Those of `others` whose plane repeats none of `known`, in their order.
std::vector<ReflectionalCandidate> without_known(std::vector<ReflectionalCandidate> others,
                                                 const std::vector<ReflectionalCandidate>& known,
                                                 const PointCloud& cloud, const EqualPlanes& equal);

}  // namespace symscene
