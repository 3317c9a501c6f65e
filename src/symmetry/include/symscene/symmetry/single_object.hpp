#pragma once

#include <vector>

#include "symscene/core/normal_estimation.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/symmetry/object_symmetry_options.hpp"
#include "symscene/symmetry/sphere_options.hpp"

namespace symscene {

/// Options of detect_object_symmetries().
struct SingleObjectOptions {
  double normalized_diagonal = 0.4;
  double voxel_size = 0.005;
  NormalEstimationOptions normals;
  SphereOptions sphere;
  SymmetrySearchOptions search;

  /// The defaults of a scene's objects, but with denser initial planes and, as no free space is
  /// known, other bounds of candidates.
  SingleObjectOptions();

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("normalized_diagonal", self.normalized_diagonal, "m", above(0.0),
          "the object is scaled to this diagonal of its bounding box; all other lengths refer to "
          "the scaled object");
    visit("voxel_size", self.voxel_size, "m", above(0.0), "spacing of points after scaling");
    visit("normals", self.normals);
    visit("sphere", self.sphere);
    // Only what decides without free space: the detectors' other bounds are those of
    // object_symmetry.
    auto& axes = self.search.rotational_detection;
    auto& planes = self.search.reflectional_detection;
    visit("axis_fit", axes.fit);
    visit("max_perpendicularity", axes.max_perpendicularity, "", between(0.0, 1.0),
          "upper bound of the mean perpendicularity of an axis (Eq. 3.6, table 4.1)");
    visit("plane_placement", planes.placement);
    visit("plane_search", planes.search);
    visit("plane_fit", planes.fit);
    visit("plane_scoring", planes.scoring);
    visit("max_points", planes.max_points, "points", at_least(8),
          "points of the object that planes are fitted to and scored on");
    visit("object_symmetry", self.search.object_symmetry);
  }
  /// Throws InputError on a field out of its range, or voxels not smaller than the object.
  void validate() const;
};

/// The symmetries of one object, in the frame and units of its cloud.
struct ObjectSymmetries {
  std::vector<ObjectAxis> rotational;     ///< at most one
  std::vector<ObjectPlane> reflectional;  ///< by ascending residual
  bool sphere = false;  ///< every line and plane through the centroid is a symmetry; none is listed
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  std::size_t points = 0;  ///< of the subsampled object that was searched
};

/// The symmetries of a single whole object, or of a partial scan of one, of any scale: the object
/// is scaled, its symmetries are searched as those of a scene's objects are, and mapped back. No
/// space is known to be free, so that the surface alone decides. Planes that hold a rotation axis
/// are not listed. Normals are estimated where `cloud` has none. Throws InputError if the cloud has
/// no extent or an option is invalid.
ObjectSymmetries detect_object_symmetries(const PointCloud& cloud,
                                          const SingleObjectOptions& options = {});

}  // namespace symscene
