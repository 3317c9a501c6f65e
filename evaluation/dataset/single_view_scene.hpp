#pragma once

#include <vector>

#include "symscene/dataset/single_view.hpp"

namespace symscene {

/// A scene from one image, with the ground truth that the labels define.
struct SingleViewScene {
  Scene scene;                    ///< in the camera frame
  SceneTruth truth;               ///< one object per label; symmetries are not known
  std::vector<std::string> lost;  ///< per object why it has no point in the cloud; empty if it has
};

/// Makes a scene from a single image with view_scene(). A point takes the label of the pixel that
/// it projects to, or of the border of a hole in which it lies, if the depth there is that of the
/// point. Throws
/// InputError if depth or labels do not have the size of the camera's image, or an option is out of
/// range.
SingleViewScene single_view_scene(const LabeledFrame& labeled,
                                  const SingleViewOptions& options = {});

}  // namespace symscene
