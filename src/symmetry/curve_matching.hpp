#pragma once

#include <optional>

#include "symscene/core/geometry.hpp"
#include "symscene/symmetry/curve_detection.hpp"

namespace symscene {

/// A curve with bounds on its positions and tangents, against which pairs are tested before their
/// points are.
struct BoundedCurve {
  explicit BoundedCurve(const EdgeCurve& bounded);

  const EdgeCurve* curve;
  Eigen::Vector3d centre;       ///< of a ball that holds all points [m]
  double radius = 0.0;          ///< [m]
  Eigen::Vector3d tangent;      ///< axis of a double cone that holds all tangents
  double tangent_spread = 0.0;  ///< its half angle [rad]
};

/// Whether two curves may have as many correspondences as the options ask for: false only if they
/// cannot. Reflection keeps the angle between a line and the plane's normal, so that both tangents
/// make nearly the same angle with the line between their points.
bool may_match(const BoundedCurve& a, const BoundedCurve& b, const CurveMatchingOptions& options);

/// The point `a` of one curve and the point `b` of the other, which reflect onto each other.
struct CurveCorrespondence {
  Index a;
  Index b;
  double angle;  ///< M_S, between one's tangent and the other's reflected one [rad] (Eq. 3.3)
};

struct CurveMatch {
  ReflectionPlane plane;
  std::vector<CurveCorrespondence> correspondences;  ///< one-to-one
  double inlier_ratio = 0.0;  ///< their number divided by that of the points of both curves
};

/// The plane that reflects two curves, or a curve and itself, onto each other: the dominant one of
/// those of all pairs of points within the bound M_S (section 3.4.2); none if it has too few
/// correspondences.
std::optional<CurveMatch> match_curves(const EdgeCurve& a, const EdgeCurve& b,
                                       const CurveMatchingOptions& options);

}  // namespace symscene
