#pragma once

#include "symscene/core/options.hpp"
#include "symscene/segmentation/euclidean_clusters.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

/// Options of the grasps around a bounding cylinder (section 4.6.3).
struct CylinderGraspOptions {
  int directions = 16;
  double height_step = 0.01;
  double palm_clearance = 0.005;
  double opening_margin = 0.002;
  double table_clearance = 0.002;
  int max_rejected = 20;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit(
        "directions", self.directions, "", between(1.0, 360.0),
        "directions of approach about the axis, and turns of the gripper about it (section 4.6.3)");
    visit("height_step", self.height_step, "m", above_up_to(0.0, 1.0),
          "distance along the axis of grasps from the side");
    visit("palm_clearance", self.palm_clearance, "m", between(0.0, 0.1),
          "least distance between palm and cylinder, and between finger tips and the lower cap");
    visit("opening_margin", self.opening_margin, "m", between(0.0, 0.1),
          "a cylinder must be thinner than the open gripper by this");
    visit("table_clearance", self.table_clearance, "m", between(0.0, 0.1),
          "least distance of the gripper from the table");
    visit("max_rejected", self.max_rejected, "", between(0, 100000),
          "most rejected candidates that an object keeps for each reason; all are counted");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// Options of the thesis's simple path from a scene to grasps (sections 4.6.2 and 4.6.3).
struct CylinderOptions {
  double voxel_size = 0.005;
  EuclideanClusterOptions clusters;
  RotationalDetectionOptions axis;
  CylinderGraspOptions grasps;

  /// The defaults of the stages, but with a looser bound of symmetry: a cluster is a whole object,
  /// with handles and edges, and the normals of a single view are noisy.
  CylinderOptions() { axis.max_symmetry_residual = 0.12; }

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", between(1e-4, 1.0),
          "spacing of the sampled cloud (section 2.1.1)");
    visit("clusters", self.clusters);
    visit("axis", self.axis);
    visit("grasps", self.grasps);
  }
  /// Throws InputError if a field is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
