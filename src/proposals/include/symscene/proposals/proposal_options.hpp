#pragma once

#include "symscene/core/options.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// Which hypotheses are one object, and which of their symmetries are one.
struct MergeOptions {
  double same_object = 0.95;
  double same_angle = radians(7.0);
  double same_distance = 0.01;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("same_object", self.same_object, "IoU", between(0.0, 1.0),
          "two hypotheses that overlap more are one object (section 4.4)");
    visit("same_angle", self.same_angle, "rad", at_least(0.0),
          "symmetries of an object closer than this and same_distance are one (section 4.4)");
    visit("same_distance", self.same_distance, "m", at_least(0.0),
          "symmetries of an object closer than this at its centroid and same_angle are one "
          "(section 4.4)");
  }
  void validate() const { check_fields(*this); }
};

/// The features of a proposal (ObjectFeatures). The embedded models were fitted with the defaults.
struct ObjectFeatureOptions {
  double crease_weight = 0.5;
  double neighbor_distance = 0.02;
  double convex_offset = 0.0025;
  double convex_slope = 0.15;
  double empty_distance = 0.01;
  int pair_points = 40;
  int neighbor_points = 200;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("crease_weight", self.crease_weight, "", between(0.0, 1.0),
          "a concave edge of the surface graph with a lower weight is a crease");
    visit("neighbor_distance", self.neighbor_distance, "m", between(0.001, 1.0),
          "distance within which a point of another proposal is near (near_others)");
    visit(
        "convex_offset", self.convex_offset, "m", at_least(0.0),
        "two points are convex if neither lies farther in front of the other's tangent plane than "
        "this and convex_slope times their distance");
    visit("convex_slope", self.convex_slope, "", at_least(0.0),
          "slope of that bound over the distance between the points");
    visit("empty_distance", self.empty_distance, "m", at_least(0.0),
          "a place farther from occupied and unseen space counts as empty");
    visit("pair_points", self.pair_points, "points", between(2, 1000),
          "sample whose pairs are compared for convexity and empty space");
    visit("neighbor_points", self.neighbor_points, "points", between(1, 1e6),
          "sample whose neighbours are examined (near_others)");
  }
  void validate() const { check_fields(*this); }
};

/// The relations of a proposal to the others of its scene (ProposalContext). The embedded models
/// were fitted with the defaults.
struct ProposalContextOptions {
  double contained_share = 0.95;
  double max_part_share = 0.9;
  double disjoint_share = 0.05;
  double min_split_share = 0.85;
  double min_piece_estimate = 0.2;
  double max_piece_overlap = 0.1;
  int max_pieces = 9;
  double own_weight = 0.15;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("contained_share", self.contained_share, "", between(0.0, 1.0),
          "a proposal lies in another that holds a greater share of its points");
    visit("max_part_share", self.max_part_share, "", between(0.0, 1.0),
          "a part has a smaller share of the points of the proposal that holds it");
    visit("disjoint_share", self.disjoint_share, "", between(0.0, 1.0),
          "two proposals are disjoint if they share at most this share of the smaller one");
    visit("min_split_share", self.min_split_share, "", between(0.0, 2.0),
          "two disjoint parts split a proposal if they have a greater share of its points");
    visit("min_piece_estimate", self.min_piece_estimate, "", between(0.0, 1.0),
          "least estimate of a part that counts as a piece of a proposal");
    visit("max_piece_overlap", self.max_piece_overlap, "", between(0.0, 1.0),
          "greatest share of a piece's points that lie in a better piece");
    visit("max_pieces", self.max_pieces, "", between(0, 1000), "greatest number of pieces");
    visit("own_weight", self.own_weight, "", between(0.0, 1.0),
          "weight of a proposal's own estimate in its score, beside that from its relations to "
          "others, which varies more from camera to camera (Genest and Zidek 1986)");
  }
  void validate() const { check_fields(*this); }
};

/// Which proposals are joined because one continues the other behind an occluder.
struct ContinuationOptions {
  int max_proposals = 40;
  double min_score = 0.1;
  double min_continuation = 0.15;
  double max_gap = 0.2;
  int sample_points = 90;
  double max_plane_offset = 0.006;
  double min_normal_cosine = 0.966;
  double empty_distance = 0.01;
  double probe_depth = 0.005;
  double min_hidden_share = 0.8;
  double max_shared = 0.05;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_proposals", self.max_proposals, "", between(0, 1000),
          "number of the best proposals that may continue another");
    visit("min_score", self.min_score, "", at_least(0.0),
          "least score of proposals that are examined");
    visit("min_continuation", self.min_continuation, "", at_least(0.0),
          "least share of points of both that continue the other, for two to be joined");
    visit("max_gap", self.max_gap, "m", at_least(0.0),
          "greatest distance between two proposals that are joined");
    visit("sample_points", self.sample_points, "points", between(1, 1000),
          "sample of a proposal that is compared with others");
    visit("max_plane_offset", self.max_plane_offset, "m", at_least(0.0),
          "two points continue each other if each is this near to the other's tangent plane");
    visit("min_normal_cosine", self.min_normal_cosine, "", between(-1.0, 1.0),
          "least cosine of the normals of two points that continue each other");
    visit("empty_distance", self.empty_distance, "m", at_least(0.0),
          "a place farther from occupied and unseen space counts as empty");
    visit("probe_depth", self.probe_depth, "m", at_least(0.0),
          "depth below the surface at which the space between two points is examined");
    visit("min_hidden_share", self.min_hidden_share, "", between(0.0, 1.0),
          "least share of pairs of continuing points between which the space is not empty");
    visit("max_shared", self.max_shared, "", between(0.0, 1.0),
          "greatest share of the smaller proposal's points that the two have in common");
  }
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
