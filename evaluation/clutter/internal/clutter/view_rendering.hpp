#pragma once

#include <vector>

#include "simulation/depth_renderer.hpp"
#include "symscene/clutter/clutter_views.hpp"

namespace symscene {

/// A renderer of objects on the table of the benchmark. Mesh k is object k, the last one the table.
DepthRenderer table_renderer(std::vector<TriangleMesh> objects);

/// The depth image of the benchmark's camera at T_world_camera, with noise.
ClutterView noisy_view(const DepthRenderer& renderer, const Eigen::Isometry3d& T_world_camera,
                       const ClutterNoiseOptions& options, const Random& noise);

}  // namespace symscene
