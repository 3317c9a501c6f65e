#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "reconstruction/surface_image.hpp"

namespace symscene {

/// A pixel of a moved image and the pixel of a fixed image onto which its point projects. Points
/// are in the fixed camera's frame.
struct ProjectivePair {
  const SurfacePixel& moved;
  const SurfacePixel& fixed;
  const Eigen::Vector3f& moved_point;  ///< [m]
  const Eigen::Vector3f& fixed_point;  ///< [m]
};

/// Projective data association (Newcombe et al. 2011, section 3.5) of two images, which must
/// outlive it.
class ProjectiveAssociation {
 public:
  ProjectiveAssociation(const SurfaceImage& moved, const SurfaceImage& fixed)
      : moved_(moved),
        fixed_(fixed),
        moved_x_(moved.camera.column_rays()),
        moved_y_(moved.camera.row_rays()),
        fixed_x_(fixed.camera.column_rays()),
        fixed_y_(fixed.camera.row_rays()) {}

  std::size_t rows() const { return moved_.camera.height; }

  /// Calls visit(ProjectivePair) for the surface pixels of row `v` of the moved image that fall on
  /// a surface pixel of the fixed image. Returns the number of surface pixels in the row.
  template <class Visit>
  std::size_t for_each_pair(std::size_t v, const Eigen::Isometry3f& T_fixed_moved,
                            const Visit& visit) const {
    std::size_t surface_pixels = 0;
    const SurfacePixel* const row = moved_.pixels.data() + v * moved_.camera.width;
    for (std::size_t u = 0; u < moved_.camera.width; ++u) {
      const SurfacePixel& pixel = row[u];
      if (!pixel.shows_surface()) continue;
      ++surface_pixels;
      const Eigen::Vector3f p =
          T_fixed_moved *
          Eigen::Vector3f(moved_x_[u] * pixel.depth, moved_y_[v] * pixel.depth, pixel.depth);
      visit_pair(pixel, p, visit);
    }
    return surface_pixels;
  }

 private:
  static constexpr float min_depth = 0.05F;  ///< of points that are projected [m]

  template <class Visit>
  void visit_pair(const SurfacePixel& pixel, const Eigen::Vector3f& p, const Visit& visit) const {
    if (!(p.z() > min_depth)) return;
    const CameraIntrinsics& camera = fixed_.camera;
    const float inverse = 1.0F / p.z();
    const float x = p.x() * inverse * static_cast<float>(camera.fx) + static_cast<float>(camera.cx);
    const float y = p.y() * inverse * static_cast<float>(camera.fy) + static_cast<float>(camera.cy);
    if (!(x > -0.5F && y > -0.5F && x < static_cast<float>(camera.width) - 0.5F &&
          y < static_cast<float>(camera.height) - 0.5F)) {
      return;
    }
    const auto column = static_cast<std::size_t>(x + 0.5F);
    const auto line = static_cast<std::size_t>(y + 0.5F);
    const SurfacePixel& other = fixed_.pixels[line * camera.width + column];
    if (!other.shows_surface()) return;
    const Eigen::Vector3f q(fixed_x_[column] * other.depth, fixed_y_[line] * other.depth,
                            other.depth);
    visit(ProjectivePair{pixel, other, p, q});
  }

  const SurfaceImage& moved_;
  const SurfaceImage& fixed_;
  std::vector<float> moved_x_, moved_y_, fixed_x_, fixed_y_;  ///< of the rays through the pixels
};

}  // namespace symscene
