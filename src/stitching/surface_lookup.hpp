#pragma once

#include <optional>

#include "symscene/reconstruction/measurement.hpp"

namespace symscene {

/// A pixel's place in its image.
struct PixelPlace {
  Index u = 0;
  Index v = 0;
};

inline const SurfacePixel& pixel_of(const SurfaceImage& image, PixelPlace place) {
  return image.pixels[std::size_t{place.v} * image.camera.width + place.u];
}

/// The point that a pixel shows, in the camera's frame. [m]
inline Eigen::Vector3d point_of(const SurfaceImage& image, PixelPlace place) {
  return static_cast<double>(pixel_of(image, place).depth) * image.camera.ray(place.u, place.v);
}

/// Where a point that is more than `nearest` before the camera falls; none beside the image and
/// where no surface is shown.
inline std::optional<PixelPlace> find_pixel(const SurfaceImage& image,
                                            const Eigen::Vector3d& point_camera, double nearest) {
  if (!(point_camera.z() > nearest)) return {};
  const Eigen::Vector2d at = image.camera.project(point_camera) + Eigen::Vector2d::Constant(0.5);
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < static_cast<double>(image.camera.width) &&
        at.y() < static_cast<double>(image.camera.height))) {
    return {};
  }
  const PixelPlace place{static_cast<Index>(at.x()), static_cast<Index>(at.y())};
  if (!pixel_of(image, place).shows_surface()) return {};
  return place;
}

/// Calls visit(place, pixel) for every pixel of an image that shows a surface.
template <class Visit>
void for_each_surface_pixel(const SurfaceImage& image, const Visit& visit) {
  for (Index v = 0; v < image.camera.height; ++v) {
    for (Index u = 0; u < image.camera.width; ++u) {
      const PixelPlace place{u, v};
      if (pixel_of(image, place).shows_surface()) visit(place, pixel_of(image, place));
    }
  }
}

}  // namespace symscene
