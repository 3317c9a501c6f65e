#pragma once

#include <nlohmann/json.hpp>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// A surface as the page reads it; null where there is none. Its vertices are in the order in which
/// its triangles first use them.
nlohmann::json surface_payload(const TriangleMesh& surface);

/// A camera's path as the page reads it, and a few of the cameras on it; null where there is none.
nlohmann::json trajectory_payload(const Trajectory& trajectory);

}  // namespace symscene
