#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/tabletop/scene_building.hpp"

namespace symscene {

/// Reconstruction options for a single view. Slanted faces, whose depth rises by a centimetre and
/// more between pixels, have to be kept, as no other view shows them better.
inline ReconstructionOptions single_view_reconstruction() {
  ReconstructionOptions options;
  options.measurement.edge_step = 0.025;
  return options;
}

struct SingleViewOptions {
  ReconstructionOptions reconstruction = single_view_reconstruction();
  SceneBuildingOptions scene;
  double label_depth = 0.015;
  int min_object_points = 100;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("reconstruction", self.reconstruction);
    visit("scene", self.scene);
    visit("label_depth", self.label_depth, "m", above(0.0),
          "largest difference between the depth of a point and of its pixel for it to take the "
          "label");
    visit("min_object_points", self.min_object_points, "", at_least(1),
          "least points at 5 mm of an object in the ground truth");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// A depth image with labels.
struct LabeledFrame {
  CameraIntrinsics camera;
  DepthFrame frame;
  std::vector<std::uint16_t> labels;  ///< one per pixel: 0 is the table or nothing, k is object k
};

}  // namespace symscene
