#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "look_images.hpp"

namespace symscene {

/// How a camera comes from view to view.
struct CameraTravel {
  /// What it costs to go to each view from where the camera is.
  std::function<std::vector<double>()> costs;
  /// Goes to a view. None if there is no way.
  std::function<std::optional<CameraMoment>(std::size_t)> to;
};

/// Takes an image from one view after the other, the next one from where symmetry expects to see
/// most (rank_views()), until no further view is expected to show much more or look.max_views are
/// taken. While nothing is known the views are taken in their order. T_table_camera.
TakenLook look_from_views(std::span<const Eigen::Isometry3d> views, const CameraTravel& travel,
                          const ArmCell& cell, const SimulatedPickOptions& options,
                          LookImages& images, TablePerception& perception);

}  // namespace symscene
