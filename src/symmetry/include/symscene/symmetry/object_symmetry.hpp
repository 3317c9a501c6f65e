#pragma once

#include "symscene/core/normal_estimation.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

struct ObjectSymmetryOptions {
  double normalized_diagonal =
      0.4;  ///< the object is scaled to this box diagonal, to which the lengths below refer [m]
  double voxel_size = 0.005;  ///< spacing after scaling [m]
  NormalEstimationOptions normals;
  RotationalDetectionOptions rotational;
  ReflectionalDetectionOptions reflectional;

  ObjectSymmetryOptions() {
    // One object instead of a scene of surfaces: denser starts, and most of it has to agree.
    rotational.max_symmetry_residual = 0.05;
    reflectional.azimuth_steps = 8;
    reflectional.max_points = 1500;
    reflectional.min_inlier_score = 0.62;
    for (CorrespondenceOptions* matching : {&reflectional.fit.matching, &reflectional.scoring}) {
      matching->min_plane_distance = 0.003;
      matching->fold_thin_walls = false;
    }
  }

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("normalized_diagonal", self.normalized_diagonal, "m",
          "the object is scaled to this box diagonal, to which all other lengths refer");
    visit("voxel_size", self.voxel_size, "m", "spacing of points after scaling");
    visit("normals", self.normals);
    visit("rotational", self.rotational);
    visit("reflectional", self.reflectional);
  }
  /// Throws InputError on a value out of its range.
  void validate() const;
};

/// The symmetries of one object, in the frame and units of its cloud.
struct ObjectSymmetries {
  std::vector<ScoredAxis> rotational;  ///< at most one; the score is Eq. 3.5, 0 is perfect
  std::vector<ScoredPlane>
      reflectional;     ///< by rising score: 1 − the share of points that agree, 0 is perfect
  bool sphere = false;  ///< every line and plane through the centroid is a symmetry; none is listed
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  std::size_t points = 0;  ///< that the search worked on
};

/// The symmetries of a single whole object or partial scan of one, of any scale, without a scene
/// around it: nothing is known of free space, so that the surface alone decides. Planes through the
/// axis of a rotational object are not listed. Normals are estimated where `cloud` has none. Throws
/// InputError if the cloud has no extent.
ObjectSymmetries detect_object_symmetries(const PointCloud& cloud,
                                          const ObjectSymmetryOptions& options = {});

}  // namespace symscene
