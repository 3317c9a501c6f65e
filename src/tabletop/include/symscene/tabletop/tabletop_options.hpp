#pragma once

#include <cstdint>

#include "symscene/core/options.hpp"

namespace symscene {

/// The search for planes that objects stand on.
struct SupportPlaneOptions {
  double inlier_distance = 0.01;
  double coarse_factor = 3.0;
  double normal_angle = radians(25.0);
  int sample = 6000;
  int hypotheses = 300;
  int max_planes = 6;
  double min_share = 0.01;
  double refined_sigmas = 2.5;
  double min_refined_distance = 0.003;
  double cell_size = 0.02;
  double min_area = 0.03;
  double wall_area = 0.25;
  double max_tilt = radians(70.0);
  double facing_factor = 0.2;
  double facing_angle = radians(45.0);
  double patch_gap = 0.4;
  double max_beneath = 0.5;
  double beneath_depth = 0.2;
  double beneath_margin = 0.05;
  double beneath_cosine = 0.7;
  double max_height = 0.6;
  double ambiguity = 0.5;
  std::uint64_t seed = 1;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    constexpr double right_angle = radians(90.0);
    visit("inlier_distance", self.inlier_distance, "m", strictly_between(0.0, 1.0),
          "largest distance of an inlier from its plane; drift bends tables by as much");
    visit("coarse_factor", self.coarse_factor, "", at_least(1.0),
          "the distance for hypotheses of one point and its normal, over inlier_distance: they are "
          "less accurate than fits");
    visit("normal_angle", self.normal_angle, "rad", strictly_between(0.0, right_angle),
          "largest angle between the normals of an inlier and its plane");
    visit("sample", self.sample, "", at_least(100.0),
          "points from which hypotheses are drawn and on which inliers are counted");
    visit("hypotheses", self.hypotheses, "", at_least(1.0), "RANSAC hypotheses per plane");
    visit("max_planes", self.max_planes, "", at_least(1.0),
          "planes that are found, walls included");
    visit("min_share", self.min_share, "", between(0.0, 1.0),
          "share of the sample that a plane must have as inliers");
    visit("refined_sigmas", self.refined_sigmas, "", above(0.0),
          "refinement keeps points within this many standard deviations of the plane");
    visit("min_refined_distance", self.min_refined_distance, "m", at_least(0.0),
          "refinement keeps all points within this distance of the plane");
    visit("cell_size", self.cell_size, "m", above(0.0),
          "edge of the cells that areas are counted in");
    visit("min_area", self.min_area, "m^2", at_least(0.0), "least area of a supporting plane");
    visit("wall_area", self.wall_area, "m^2", at_least(0.0),
          "planes of at least this area are walls; their points are not points of objects");
    visit("max_tilt", self.max_tilt, "rad", above(0.0),
          "largest angle between a supporting plane's normal and up, where up is known; large, as "
          "a camera that looks down on a table is tilted itself");
    visit("facing_factor", self.facing_factor, "", between(0.0, 1.0),
          "score factor of a plane tilted beyond max_tilt that faces the cameras: a table seen "
          "from straight above, or a wall");
    visit("facing_angle", self.facing_angle, "rad", between(0.0, right_angle),
          "a plane faces the cameras if its normal is within this angle of the direction to them");
    visit(
        "patch_gap", self.patch_gap, "m", at_least(0.0),
        "gap between patches of one table, which the shadows of objects cut; a patch farther from "
        "the others is of another table");
    visit("max_beneath", self.max_beneath, "", at_least(0.0),
          "greatest number of steep points just below a supporting plane, divided by its inliers: "
          "the sides of a box are below its lid, while a table hides what is below it");
    visit("beneath_depth", self.beneath_depth, "m", above(0.0),
          "depth below the plane in which steep points are counted");
    visit("beneath_margin", self.beneath_margin, "m", at_least(0.0),
          "distance from the plane's outline up to which steep points are counted");
    visit("beneath_cosine", self.beneath_cosine, "", between(-1.0, 1.0),
          "a point is steep if the cosine between its normal and the plane's is below this");
    visit("max_height", self.max_height, "m", above(0.0),
          "height above a supporting plane up to which points belong to objects on it");
    visit("ambiguity", self.ambiguity, "", above_up_to(0.0, 1.0),
          "share of the best plane's score from which another plane is an alternative");
    visit("seed", self.seed, "", any_value(), "seed of the hypotheses");
  }
  /// Throws InputError if a value is out of its range or max_height is not above inlier_distance.
  void validate() const;
};

/// Crop of the points above a table.
struct TableCropOptions {
  double voxel_size = 0.005;
  double min_clearance = 0.005;
  double max_clearance = 0.015;
  double max_rough_clearance = 0.06;
  double rough_clearance_sigmas = 2.0;
  int roughness_cells = 12;
  int min_roughness_points = 50;
  double clearance_sigmas = 3.0;
  double overhang = 0.05;
  double link = 0.012;
  int min_fragment = 40;
  bool follow_bend = true;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", above(0.0),
          "spacing of the objects' points (section 2.1.2)");
    visit("min_clearance", self.min_clearance, "m", at_least(0.0),
          "least height from which points belong to objects");
    visit("max_clearance", self.max_clearance, "m", at_least(0.0),
          "upper bound of this height on rough tables");
    visit("max_rough_clearance", self.max_rough_clearance, "m", at_least(0.0),
          "upper bound of this height at places where the table is measured more roughly than "
          "elsewhere, as far away");
    visit("rough_clearance_sigmas", self.rough_clearance_sigmas, "", at_least(0.0),
          "the height at a place in standard deviations of the points below the table there");
    visit("roughness_cells", self.roughness_cells, "", between(1, 1000),
          "places along the longer side of a table at which its roughness is measured");
    visit("min_roughness_points", self.min_roughness_points, "points", at_least(1),
          "points below the table from which a place's roughness is known");
    visit("clearance_sigmas", self.clearance_sigmas, "", at_least(0.0),
          "the height in standard deviations of the table's points, between these bounds");
    visit("overhang", self.overhang, "m", at_least(0.0),
          "how far an object may reach beyond the table's border");
    visit("link", self.link, "m", above(0.0),
          "points closer than this are of one fragment; more where points are farther apart than "
          "voxel_size");
    visit("min_fragment", self.min_fragment, "", at_least(1.0),
          "points of the smallest fragment that is kept");
    visit("follow_bend", self.follow_bend, "", any_value(),
          "measure heights above a quadric, as drift bends tables");
  }
  /// Throws InputError if a value is out of its range or max_clearance is below min_clearance.
  void validate() const;
};

struct TableSceneOptions {
  SupportPlaneOptions plane;
  TableCropOptions crop;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("plane", self.plane);
    visit("crop", self.crop);
  }
  /// Throws InputError if a value is out of its range or plane.max_height is not above
  /// crop.max_clearance.
  void validate() const;
};

}  // namespace symscene
