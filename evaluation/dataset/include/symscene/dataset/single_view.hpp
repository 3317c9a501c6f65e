#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symscene/tabletop/view_scene.hpp"

namespace symscene {

struct SingleViewOptions {
  ViewSceneOptions view;
  double label_depth = 0.015;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("view", self.view);
    visit("label_depth", self.label_depth, "m", above(0.0),
          "largest difference between the depth of a point and of its pixel for it to take the "
          "label");
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
