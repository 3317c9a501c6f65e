#pragma once

#include <numbers>
#include <vector>

#include "symscene/core/options.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"

namespace symscene {

struct CompletionOptions {
  double spacing = 0.005;
  double free_tolerance = 0.01;
  double square_tolerance = radians(10.0);
  double min_determined = 0.02;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("spacing", self.spacing, "m", between(1e-4, 1.0), "spacing of the added points");
    visit("free_tolerance", self.free_tolerance, "m", at_least(0.0),
          "images farther inside observed free space are left out");
    visit("square_tolerance", self.square_tolerance, "rad", between(0.0, std::numbers::pi / 2),
          "planes combine if the angle between them is a right angle up to this");
    visit("min_determined", self.min_determined, "", at_least(0.0),
          "least eigenvalue of a direction in which the symmetries determine the centre of mass; "
          "0.02 is that of two planes 11 degrees apart");
  }
  void validate() const { check_fields(*this); }
};

/// The unobserved side of an object: the images of its observed points under its symmetries
/// (section 1.3), rotated about the axes in steps of the spacing, reflected by the planes and by
/// their products. Images in observed free space and those near observed points are left out.
/// Normals and colours are those of the originals. `observed` has unit normals and is in the frame
/// of the symmetries and of `field`; symmetries come by ascending residual. Throws InputError on
/// invalid options.
PointCloud complete_object(const PointCloud& observed, const std::vector<ObjectAxis>& axes,
                           const std::vector<ObjectPlane>& planes, const DistanceField& field,
                           const CompletionOptions& options = {});

/// An object's observed points, those that complete_object() added, and its symmetries.
struct CompletedObject {
  const PointCloud& observed;
  const PointCloud& added;
  const std::vector<ObjectAxis>& axes;
  const std::vector<ObjectPlane>& planes;
};

/// The centre of mass of a body of uniform density, which lies on every axis and plane of symmetry
/// (section 1.3): the mean of the observed and the added points, projected onto all of them by
/// least squares. Directions that nearly equal symmetries do not determine are left as they are.
/// [m]
Eigen::Vector3d centre_of_mass(const CompletedObject& object,
                               const CompletionOptions& options = {});

}  // namespace symscene
