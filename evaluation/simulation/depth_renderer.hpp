#pragma once

#include <memory>
#include <span>

#include "symscene/core/triangle_mesh.hpp"
#include "symscene/simulation/sensor_frame.hpp"

namespace symscene {

/// Casts rays at meshes. Rendering is const and may run from many threads at once.
class DepthRenderer {
 public:
  /// Keeps what it needs of the meshes; their positions in the span name them in frames.
  explicit DepthRenderer(std::span<const TriangleMesh> meshes);
  ~DepthRenderer();
  DepthRenderer(DepthRenderer&&) noexcept;
  DepthRenderer& operator=(DepthRenderer&&) noexcept;

  /// The exact image from a pose: depth at pixel centres, colours shaded by a lamp at the camera.
  SensorFrame render(const CameraIntrinsics& camera, const Eigen::Isometry3d& T_world_camera) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
