#pragma once

#include <nlohmann/json.hpp>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/viewer/page.hpp"

namespace symscene {

/// A surface as the page reads it; null if it is empty. Vertices are in the order in which the
/// triangles first use them.
nlohmann::json surface_payload(const TriangleMesh& surface);

/// The closed surface of an object, thinned to at most `max_triangles`: as above, observed vertices
/// white and inferred ones black.
nlohmann::json closed_payload(const ObjectSurface& surface, Index max_triangles);

/// A camera's position and its axes: right, down and forward are x, y and z.
nlohmann::json camera_payload(const Eigen::Isometry3d& T_world_camera);

/// A camera path as the page reads it, with a few cameras on it; null if it is empty.
nlohmann::json trajectory_payload(const Trajectory& trajectory);

/// A depth image as the page reads it. Throws InputError if it has not one value per pixel.
nlohmann::json depth_payload(const ShownDepth& depth);

/// The frames of a sweep with their cameras and depth images; null without frames.
nlohmann::json sweep_payload(const std::vector<PageFrame>& sweep);

}  // namespace symscene
