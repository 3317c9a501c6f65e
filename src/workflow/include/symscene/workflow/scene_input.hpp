#pragma once

#include "symscene/core/scene.hpp"
#include "symscene/tabletop/view_scene.hpp"
#include "symscene/workflow/known_table.hpp"
#include "symscene/workflow/sensor_choice.hpp"

namespace symscene {

/// A depth image as a scene, in its camera's frame.
struct ViewInput {
  ViewScene scene;
  TriangleMesh surface;  ///< of the whole image
  Trajectory cameras;    ///< the one camera, at the origin
  DepthFrame frame;      ///< as SensorChoice::prepared() gives it
};

/// Makes a scene of a depth image with the noise of its sensor. Throws InputError as view_scene().
ViewInput view_input(DepthFrame frame, const CameraIntrinsics& camera, const SensorChoice& sensor,
                     const KnownTable& table, const ViewSceneOptions& options = {});

/// The result of a scene without points: its table and warnings.
SegmentationResult nothing_found(const Scene& scene);

}  // namespace symscene
