#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/geometry.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Options of find_symmetry_group().
struct SymmetryGroupOptions {
  double tolerance = 0.01;
  double part_share = 0.01;
  double part_distance = 0.12;
  double radius_share = 0.1;
  int max_order = 12;
  int directions = 2000;
  int coarse_points = 250;
  int fit_points = 500;
  int residual_points = 2000;
  double step_distance = 0.02;
  double candidate_angle = radians(7.0);
  int max_candidates = 16;
  double same_angle = radians(5.0);
  double tilt_angle = radians(4.0);
  double order_ratio = 3.0;
  double product_ratio = 1.5;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("tolerance", self.tolerance, "", above_up_to(0.0, 0.2),
          "a motion is a symmetry if it moves the surface off itself by no more than this share of "
          "the object's diagonal, on average");
    visit("part_share", self.part_share, "", between(0.0, 1.0),
          "a motion is no symmetry if it moves more than this share of the surface, such as a "
          "handle, off it by more than part_distance");
    visit("part_distance", self.part_distance, "", above(0.0),
          "see part_share, by the object's diagonal");
    visit(
        "radius_share", self.radius_share, "", above(0.0),
        "largest mean distance of the turned surface from itself, over its mean distance from the "
        "axis, for turns by less than a half: relative to the diagonal slender objects move "
        "little");
    visit("max_order", self.max_order, "", between(2, 24),
          "largest order of an axis; with more, a turn counts as continuous");
    visit("directions", self.directions, "", between(100, 100000),
          "directions of planes and axes that are tried, evenly spread over the hemisphere");
    visit("coarse_points", self.coarse_points, "points", at_least(50),
          "points of the surface on which all directions are tried");
    visit("fit_points", self.fit_points, "points", at_least(50),
          "points of the surface to which candidates are fitted");
    visit("residual_points", self.residual_points, "points", at_least(50),
          "points of the surface on which the final residual is computed");
    visit("step_distance", self.step_distance, "", at_least(0.0),
          "added to the tolerance while candidates are not fitted yet: a direction between those "
          "that are tried moves the surface by up to this share of the object's diameter");
    visit("candidate_angle", self.candidate_angle, "rad", above(0.0),
          "candidates are directions whose residual is the least within this angle");
    visit("max_candidates", self.max_candidates, "", at_least(1),
          "candidates that are fitted, for planes and for each order of an axis");
    visit("same_angle", self.same_angle, "rad", above(0.0),
          "fitted symmetries of directions closer than this are one");
    visit("tilt_angle", self.tilt_angle, "rad", above(0.0),
          "a symmetry whose residual falls when it is tilted by this angle is rejected");
    visit("order_ratio", self.order_ratio, "", at_least(1.0),
          "a higher order of an axis is accepted up to this multiple of the residual of the best");
    visit("product_ratio", self.product_ratio, "", at_least(1.0),
          "products of symmetries may exceed the tolerance by this factor, as errors add up");
  }
  /// Throws InputError on a field out of its range.
  void validate() const { check_fields(*this); }
};

/// A rotational symmetry of a whole surface.
struct GroupAxis {
  static constexpr int continuous = 0;

  RotationAxis axis;
  int order = continuous;  ///< the surface repeats every 2π / order, or at every angle
  double residual = 0.0;   ///< mean distance from the surface, for the worst angle [m]
};

/// A reflectional symmetry of a whole surface.
struct GroupPlane {
  ReflectionPlane plane;
  double residual = 0.0;  ///< mean distance of the reflected surface from the surface [m]
};

/// The symmetry group of a whole surface within a tolerance, in the frame and unit of the surface.
struct SymmetryGroup {
  double diameter = 0.0;                             ///< greatest distance of two points [m]
  double diagonal = 0.0;                             ///< of the narrowest box around it [m]
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< which all symmetries leave in place [m]
  bool sphere = false;  ///< all lines and planes through the centre are symmetries; none is listed
  double sphere_residual = 0.0;  ///< mean deviation of the radii of a sphere [m]
  /// By descending order, a continuous axis first. With a continuous axis, the one other axis
  /// stands for all half turns that exchange its ends.
  std::vector<GroupAxis> axes;
  /// By ascending residual. Planes that contain a continuous axis are not listed.
  std::vector<GroupPlane> planes;
  /// The proper rotations other than the identity, an exact group with it (and, with a continuous
  /// axis, with the turns about that axis).
  std::vector<Eigen::Isometry3d> rotations;
};

/// Finds the symmetries of a whole surface (a closed mesh, or a cloud of all sides) of any scale:
/// planes and axes through the centroid are tried in all directions, fitted to the surface point to
/// plane, and kept where their residual is within the tolerance. `surface` needs normals and even
/// density. Throws InputError if it has no extent, or an option is invalid.
SymmetryGroup find_symmetry_group(const PointCloud& surface,
                                  const SymmetryGroupOptions& options = {});

/// A cloud of a whole object as find_symmetry_group() needs it: thinned to even density, with
/// normals estimated where there are none. Throws InputError if the points span no surface.
PointCloud even_surface(const PointCloud& cloud);

/// Points of even density on a mesh, with normals, as find_symmetry_group() needs them. Throws
/// InputError if the mesh has no triangle of positive area.
PointCloud even_surface(const TriangleMesh& mesh);

}  // namespace symscene
