#pragma once

#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/tabletop/view_scene.hpp"
#include "symscene/workflow/known_table.hpp"

namespace symscene {

/// A reconstruction, its surface, and the cameras of the fused frames. World frame.
struct ReconstructedModel {
  const Reconstruction& reconstruction;
  const TriangleMesh& surface;
  const Trajectory& cameras;
};

/// The scene of a reconstruction: finds the table in its surface as build_scene() does. If no point
/// is on the given plane, all that is seen is taken. Warnings tell that, and those of the
/// reconstruction. Throws InputError if the surface is empty.
BuiltScene reconstructed_scene(const ReconstructedModel& model, const KnownTable& table,
                               const SceneBuildingOptions& options = {});

/// A sequence of one frame as a scene, and its surface. World frame.
struct ReconstructedView {
  ViewScene view;
  TriangleMesh surface;
};

/// The scene of a single frame: its own pixels are the surface. If no point is on the given plane,
/// all that is seen is taken, and a warning says so. Throws InputError as view_scene().
ReconstructedView reconstructed_view(const DepthView& view, const KnownTable& table,
                                     const ViewSceneOptions& options = {});

}  // namespace symscene
