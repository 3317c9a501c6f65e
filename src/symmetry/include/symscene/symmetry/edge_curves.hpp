#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "symscene/core/neighbors.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// How the curves along the edges of a surface are found (section 3.4.1).
struct EdgeCurveOptions {
  bool outlines = true;
  double min_rim_gap = radians(110.0);
  double min_bend = radians(30.0);
  double radius = 0.01;
  double spacing = 0.005;
  double link_distance = 0.016;
  double tangent_radius = 0.015;
  double corner_angle = radians(45.0);
  double min_length = 0.025;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("outlines", self.outlines, "", any_value(),
          "the rim of the observed surface is an edge too");
    visit("min_rim_gap", self.min_rim_gap, "rad", between(0.0, 2.0 * std::numbers::pi),
          "a point is on the rim if its neighbours leave a larger angle about it empty");
    visit("min_bend", self.min_bend, "rad", between(0.0, std::numbers::pi),
          "the border of two facets is an edge where the surface bends by at least this; 0 takes "
          "all borders, "
          "as the thesis");
    visit("radius", self.radius, "m", above(0.0),
          "radius of the neighbourhood in which rim and bend are judged, and within which the band "
          "of "
          "boundary points along an edge is contracted to a line");
    visit("spacing", self.spacing, "m", above(0.0), "least distance between points of curves");
    visit("link_distance", self.link_distance, "m", above(0.0),
          "longest link of the minimum spanning tree (section 3.4.1)");
    visit("tangent_radius", self.tangent_radius, "m", above(0.0),
          "length of the curve on both sides of a point to which its tangent is fitted (section "
          "3.4.1)");
    visit("corner_angle", self.corner_angle, "rad", between(0.0, std::numbers::pi),
          "a curve is split where it turns by more over tangent_radius");
    visit("min_length", self.min_length, "m", above(0.0), "shorter curves are left out");
  }
  /// Throws InputError if a field is out of its range or link_distance is not above spacing.
  void validate() const;
};

/// An edge of the surface: an ordered path of points (section 3.4.1).
struct EdgeCurve {
  struct Point {
    Eigen::Vector3d position;
    Eigen::Vector3d tangent;  ///< unit vector, of either sign
    PointIndices members;     ///< points of the cloud that it stands for, ascending
  };
  std::vector<Point> points;

  double length() const;  ///< [m]
};

/// The curves along the borders of the facets of a cloud (one label per point) and, with
/// `outlines`, along the rim of the surface: boundary points are linked by a minimum spanning tree,
/// which is split into paths without branches, and these at corners (section 3.4.1); paths that go
/// on as each other are joined. `cloud` has unit normals, `neighbors` its points in adjacent
/// voxels. Throws InputError on invalid options.
std::vector<EdgeCurve> edge_curves(const PointCloud& cloud, const NeighborLists& neighbors,
                                   std::span<const Index> facets,
                                   const EdgeCurveOptions& options = {});

}  // namespace symscene
