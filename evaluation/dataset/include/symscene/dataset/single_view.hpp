#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/tabletop/scene_building.hpp"

namespace symscene {

/// What is different of a single look: it has to do with slanted faces too, whose depths rise in
/// steps of a centimetre and more.
inline ReconstructionOptions of_one_look() {
  ReconstructionOptions options;
  options.measurement.edge_step = 0.025;
  return options;
}

struct SingleViewOptions {
  ReconstructionOptions reconstruction = of_one_look();
  SceneBuildingOptions scene;
  double label_depth = 0.015;   ///< from its pixel's depth up to which a point has its label [m]
  int min_object_points = 100;  ///< at 5 mm; the truth leaves out what shows fewer

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("reconstruction", self.reconstruction);
    visit("scene", self.scene);
    visit("label_depth", self.label_depth, "m",
          "from its pixel's depth, of a point with its label");
    visit("min_object_points", self.min_object_points, "", "points at 5 mm that truth asks for");
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

/// A depth image and what is known of its pixels.
struct LabeledFrame {
  CameraIntrinsics camera;
  DepthFrame frame;
  std::vector<std::uint16_t> labels;  ///< one a pixel: 0 is the table or nothing, k is object k
};

/// A scene of one image, and what the labels say of it.
struct SingleViewScene {
  Scene scene;                      ///< in the camera's frame; empty without a table
  SceneTruth truth;                 ///< masks; symmetries are not known
  std::vector<std::size_t> labels;  ///< that the image has, ascending
};

/// Makes a scene of a single image, as of a sequence of one: what lies behind it was never seen.
/// A point has the label of the pixel that it falls on if that was measured at its depth.
/// Throws InputError if depth or labels are not of the camera's size, or an option is out of range.
SingleViewScene single_view_scene(const LabeledFrame& labeled,
                                  const SingleViewOptions& options = {});

}  // namespace symscene
