#pragma once

#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/options.hpp"
#include "symscene/symmetry/axis_fit.hpp"
#include "symscene/symmetry/point_scores.hpp"

namespace symscene {

/// When the reflection of a point counts as another point (section 3.5.3).
struct CorrespondenceOptions {
  double max_distance = 0.01;        ///< between the reflected point and its match [m]
  double max_angle = radians(45.0);  ///< between their normals [rad]
  double min_plane_distance =
      0.01;  ///< a point nearer to the plane matches itself and proves nothing [m]
  bool fold_thin_walls =
      true;  ///< opposite normals match: both faces of a wall thinner than a voxel

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_distance", self.max_distance, "m",
          "greatest distance of a reflected point from its match");
    visit("max_angle", self.max_angle, "rad", "greatest angle between their normals");
    visit("min_plane_distance", self.min_plane_distance, "m",
          "points nearer to the plane prove nothing");
    visit("fold_thin_walls", self.fold_thin_walls, "",
          "opposite normals match, as on the faces of a thin wall");
  }
  /// Throws InputError on a distance that is negative or an angle outside (0, π].
  void validate() const;
};

/// A point and the point that it reflects to.
struct Correspondence {
  Index from;
  Index to;
  float squared_distance;  ///< of the reflected point from the match [m²]
  float angle;  ///< between the reflected normal and the match's, folded where walls are thin [rad]
};

/// Every point of `sources` whose reflection lies near a point of `cloud` (which `cells` holds),
/// with the nearest such point. Several may share a match.
std::vector<Correspondence> reflect_onto(const PointCloud& cloud, const CellList& cells,
                                         std::span<const Index> sources,
                                         const ReflectionPlane& plane,
                                         const CorrespondenceOptions& options);

/// Each match once: the nearest reflection keeps it, ties go to the lower source.
std::vector<Correspondence> one_to_one(std::vector<Correspondence> correspondences);

struct PlaneFitOptions {
  CorrespondenceOptions matching{0.008, radians(45.0), 0.01, true};
  int max_iterations = 20;                 ///< section 3.5.3
  double angle_tolerance = radians(0.05);  ///< a step below this [rad]
  double distance_tolerance = 1e-4;        ///< and this ends the fit [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("matching", self.matching);
    visit("max_iterations", self.max_iterations, "", "most rounds of matching and solving");
    visit("angle_tolerance", self.angle_tolerance, "rad",
          "a step below this and distance_tolerance ends the fit");
    visit("distance_tolerance", self.distance_tolerance, "m",
          "a step below this and angle_tolerance ends the fit");
  }
  /// Throws InputError on a value that is not positive.
  void validate() const;
};

struct PlaneFit {
  ReflectionPlane plane;
  std::size_t correspondences = 0;
  FitStatus status = FitStatus::too_few_points;
};

/// The plane near `initial` that reflects `sources` onto `cloud`: matching and point-to-plane least
/// squares in the plane's three degrees of freedom in turn (Eq. 3.7). Steps that the matches do not
/// determine (a flat face slid in its own plane) are not taken. The plane's point is the foot of
/// the sources' centroid.
PlaneFit fit_plane(const PointCloud& cloud, const CellList& cells, std::span<const Index> sources,
                   const ReflectionPlane& initial, const PlaneFitOptions& options = {});

}  // namespace symscene
