#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "symscene/core/camera.hpp"

namespace symscene {

/// The pixel onto which a point projects; none behind the camera or outside the image.
std::optional<Eigen::Vector2i> projected_pixel(const Eigen::Vector3d& point_camera,
                                               const CameraIntrinsics& camera);

/// The pixel of a depth image that shows a point: that onto which it projects or, in a hole of up
/// to 8 pixels around it, that of the most similar depth at the border of the hole. None outside
/// the image and in greater holes.
std::optional<std::size_t> pixel_showing(const Eigen::Vector3d& point_camera,
                                         std::span<const float> depth,
                                         const CameraIntrinsics& camera);

}  // namespace symscene
