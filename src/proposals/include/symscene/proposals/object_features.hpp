#pragma once

#include <cstddef>

namespace symscene {

/// Features of a proposal that do not depend on the others of its scene. Edges are those of the
/// surface graph, whose weights are in [0, 1]. The thresholds are ObjectFeatureOptions.
struct OwnFeatures {
  double broken = 0.0;           ///< weight of the edges that leave, over the root of its size
  double torn = 0.0;             ///< share of the leaving edges that are not creases
  double rim = 0.0;              ///< points with a leaving edge, over the root of its size
  double bend = 0.0;             ///< mean 1 - weight of the concave edges inside, 0 for convex ones
  double crease = 0.0;           ///< share of the edges inside that are creases
  double seam = 0.0;             ///< SurfaceRegions::seam()
  double fold = 0.0;             ///< SurfaceRegions::seam() of the patches
  double fold_rim = 0.0;         ///< SurfaceRegions::rim() of the patches
  double unity = 0.0;            ///< share of the largest connected component
  double near_unity = 0.0;       ///< the same of its patches, with small gaps bridged
  double convexity = 0.0;        ///< share of pairs of points that are convex
  double empty = 0.0;            ///< share of places between two points that were seen empty
  double width_ratio = 0.0;      ///< extent along the second principal axis over the longest
  double thickness_ratio = 0.0;  ///< the shortest extent over the longest
  double near_others = 0.0;      ///< share of points that are near a point outside
  double axes = 0.0;             ///< rotational symmetries of its hypotheses
  double axis_misfit = 1.0;      ///< least residual of these (Eq. 3.5)
  double axis_occlusion = 1.0;   ///< least occlusion residual (Eq. 4.3)
  double planes = 0.0;           ///< reflectional symmetries of its hypotheses, at most 4
  double plane_inlier = 0.0;     ///< greatest inlier share of these (Eq. 3.10)
  double plane_occlusion = 1.0;  ///< least occlusion residual (Eq. 4.7)
  double confidence = 0.0;       ///< of its most confident hypothesis (section 4.3.3); 0 for none
};

/// All features of a proposal from which the probability that it is one whole object is estimated.
struct ObjectFeatures : OwnFeatures {
  double continued = 0.0;  ///< greatest continuation by another proposal (continuation())
  double joined = 0.0;     ///< continuation of two proposals by each other that make it up

  /// Calls visit(name, value) for every feature, in this order, which is that of the models.
  template <class Self, class Visit>
  static constexpr void visit_fields(Self& self, Visit&& visit) {
    visit("broken", self.broken);
    visit("torn", self.torn);
    visit("rim", self.rim);
    visit("bend", self.bend);
    visit("crease", self.crease);
    visit("seam", self.seam);
    visit("fold", self.fold);
    visit("fold_rim", self.fold_rim);
    visit("unity", self.unity);
    visit("near_unity", self.near_unity);
    visit("convexity", self.convexity);
    visit("empty", self.empty);
    visit("width_ratio", self.width_ratio);
    visit("thickness_ratio", self.thickness_ratio);
    visit("near_others", self.near_others);
    visit("axes", self.axes);
    visit("axis_misfit", self.axis_misfit);
    visit("axis_occlusion", self.axis_occlusion);
    visit("planes", self.planes);
    visit("plane_inlier", self.plane_inlier);
    visit("plane_occlusion", self.plane_occlusion);
    visit("continued", self.continued);
    visit("joined", self.joined);
    visit("confidence", self.confidence);
  }
};

/// Features of a proposal's relations to the others of its scene: those that contain it (wholes),
/// that it contains (parts), and that cross it (conflicts). An estimate is the
/// estimated_probability() of a proposal from its own features. The thresholds are
/// ProposalContextOptions.
struct ProposalContext {
  double estimate = 0.0;     ///< its own estimate
  double whole = 0.0;        ///< greatest estimate of a whole
  double whole_share = 0.0;  ///< its size divided by that of this whole
  double part = 0.0;         ///< greatest estimate of a part
  double rival = 0.0;        ///< greatest estimate of a conflicting proposal
  double rest = 0.0;         ///< greatest estimate of a part that splits that whole with it
  double split = 0.0;        ///< greatest, over pairs of parts that split it, of the lower estimate
  double covered = 0.0;      ///< share of its points in pieces: likely, disjoint parts, best first
  double covered_score = 0.0;  ///< the same, each piece weighted by its estimate
  double pieces = 0.0;         ///< number of pieces
  double wholes = 0.0;         ///< ln(1 + number of wholes)
  double parts = 0.0;          ///< ln(1 + number of parts)

  /// Calls visit(name, value) for every feature, in this order, which is that of the models.
  template <class Self, class Visit>
  static constexpr void visit_fields(Self& self, Visit&& visit) {
    visit("estimate", self.estimate);
    visit("whole", self.whole);
    visit("whole_share", self.whole_share);
    visit("part", self.part);
    visit("rival", self.rival);
    visit("rest", self.rest);
    visit("split", self.split);
    visit("covered", self.covered);
    visit("covered_score", self.covered_score);
    visit("pieces", self.pieces);
    visit("wholes", self.wholes);
    visit("parts", self.parts);
  }
};

}  // namespace symscene
