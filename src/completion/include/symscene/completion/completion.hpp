#pragma once

#include "symscene/core/options.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"

namespace symscene {

struct CompletionOptions {
  double spacing = 0.005;        ///< between added points [m]
  double free_tolerance = 0.01;  ///< images farther inside space seen empty are left out [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("spacing", self.spacing, "m", "between added points");
    visit("free_tolerance", self.free_tolerance, "m",
          "images farther inside empty space are left out");
  }
  /// Throws InputError on a spacing that is not positive or a tolerance below 0.
  void validate() const;
};

/// The side of an object that no camera saw: the images of its observed points under its symmetries
/// (turned about the axes in steps that keep the spacing, reflected by the planes and by their
/// products), without those in space that was seen empty and those where the object was observed
/// anyway. Normals follow; colours are those of the originals. `observed` has normals.
PointCloud complete_object(const PointCloud& observed, const std::vector<ScoredAxis>& axes,
                           const std::vector<ScoredPlane>& planes, const DistanceField& field,
                           const CompletionOptions& options = {});

/// The centre of mass of a body of even density: it lies on every axis and plane of its symmetry
/// (section 1.3). The mean of the observed and the added points, brought onto all of them by least
/// squares; along directions that nearly equal symmetries do not determine it stays where it is.
/// [m]
Eigen::Vector3d centre_of_mass(const PointCloud& observed, const PointCloud& added,
                               const std::vector<ScoredAxis>& axes,
                               const std::vector<ScoredPlane>& planes);

}  // namespace symscene
