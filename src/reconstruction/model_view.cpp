#include "reconstruction/model_view.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "depth_ranges.hpp"
#include "field.hpp"

namespace symscene {
namespace {

constexpr Index tile = DepthRanges::tile;

/// Casts rays of one camera, lengths being depths. [voxels]
class RayCaster {
 public:
  RayCaster(const TsdfVolume& volume, const Eigen::Isometry3d& T_world_camera)
      : field_(volume),
        R_world_camera_(T_world_camera.linear().cast<float>()),
        origin_((T_world_camera.translation() / volume.voxel_size()).cast<float>()),
        voxel_size_(static_cast<float>(volume.voxel_size())),
        voxels_per_unit_(volume.distance_unit() / voxel_size_) {}

  /// The first surface along the ray between two depths. [m]
  SurfacePixel cast(const Eigen::Vector3f& ray_camera, float nearest, float farthest) {
    const Eigen::Vector3f ray = R_world_camera_ * ray_camera;
    const float length = ray.norm();
    const float inverse_length = 1.0F / length;
    const Eigen::Vector3f inverse_ray = ray.cwiseInverse();
    const float end = farthest / voxel_size_;
    float at = nearest / voxel_size_;
    float before = -1.0F, last = 0.0F;  // the last positive distance and its depth
    while (at < end) {
      const Eigen::Vector3f p = origin_ + at * ray;
      const int x = floor_of(p.x()), y = floor_of(p.y()), z = floor_of(p.z());
      const TsdfBlock* block = field_.block_at(x, y, z);
      if (!field_.last_is_near_surface()) {
        at = leave_block(p, inverse_ray, at, {x, y, z});
        continue;
      }
      const std::int16_t units =
          block->distance[static_cast<std::size_t>(FieldReader::place(x, y, z))];
      if (units == TsdfBlock::never_seen) {
        at += inverse_length;
        continue;
      }
      const float distance = static_cast<float>(units) * voxels_per_unit_;
      if (distance <= 0.0F) {
        if (before < 0.0F) return {};
        return cross(ray, before + (at - before) * last / (last - distance), length);
      }
      before = at;
      last = distance;
      at += std::max(relaxation * distance, 1.0F) * inverse_length;
    }
    return {};
  }

 private:
  static constexpr int max_steps = 4;
  /// Over-relaxation, as rays seldom meet a surface at a right angle; a step too far is detected by
  /// the sign behind the surface.
  static constexpr float relaxation = 1.4F;

  /// The depth at which the ray leaves the block of a voxel.
  static float leave_block(const Eigen::Vector3f& p, const Eigen::Vector3f& inverse_ray, float at,
                           const Eigen::Vector3i& voxel) {
    float step = 64.0F;
    for (int axis = 0; axis < 3; ++axis) {
      const auto wall = static_cast<float>((voxel[axis] & ~7) + (inverse_ray[axis] > 0.0F ? 8 : 0));
      const float reached = (wall - p[axis]) * inverse_ray[axis];
      step = reached < step ? reached : step;  // NaN for a ray along the wall
    }
    return at + std::max(step, 0.0F) + 1e-2F;
  }

  /// Finds the crossing near a depth by Newton's method on the interpolated field.
  SurfacePixel cross(const Eigen::Vector3f& ray, float at, float length) {
    float corners[8];
    Eigen::Vector3f between;
    for (int k = 0; k < max_steps; ++k) {
      if (!field_.corners(origin_ + at * ray, corners, between)) return {};
      const Eigen::Vector3f gradient = trilinear_gradient(corners, between);
      const float slope = gradient.dot(ray);
      if (!(slope < 0.0F)) return {};
      const float step = trilinear(corners, between) / slope;
      at -= step;
      if (std::abs(step) * length < 0.3F) return surface(at, gradient);
      if (std::abs(step) * length > 3.0F) return {};
    }
    return {};
  }

  SurfacePixel surface(float at, const Eigen::Vector3f& gradient) const {
    const float norm = gradient.norm();
    if (!(norm > 0.0F)) return {};
    const Eigen::Vector3f normal = R_world_camera_.transpose() * (gradient / norm);
    return {at * voxel_size_, normal.x(), normal.y(), normal.z()};
  }

  FieldReader field_;
  Eigen::Matrix3f R_world_camera_;
  Eigen::Vector3f origin_;
  float voxel_size_;
  float voxels_per_unit_;
};

/// Casts a view in two passes: the corners of the tiles, then the pixels between them.
class ViewCaster {
 public:
  ViewCaster(const TsdfVolume& volume, ModelView& view)
      : volume_(volume),
        view_(view),
        camera_(view.image.camera),
        ranges_(find_depth_ranges(volume, camera_, view.T_world_camera.inverse())),
        band_(static_cast<float>(1.5 * volume.options().truncation)),
        ray_x_(camera_.column_rays()),
        ray_y_(camera_.row_rays()) {}

  void cast() {
    const std::size_t rows = (camera_.height + tile - 1) / tile;
    for_each_row(rows + 1, [&](RayCaster& caster, Index row) { cast_corners(caster, row); });
    for_each_row(rows, [&](RayCaster& caster, Index row) { cast_tiles(caster, row); });
  }

 private:
  template <class Body>
  void for_each_row(std::size_t rows, const Body& body) const {
    parallel_for_each(rows, [&](std::size_t row) {
      RayCaster caster(volume_, view_.T_world_camera);
      body(caster, static_cast<Index>(row));
    });
  }

  /// The last corners of a row and of the image are its last pixels.
  static Index corner(Index number, Index size) { return std::min(number * tile, size - 1); }

  SurfacePixel& pixel(Index u, Index v) const {
    return view_.image.pixels[std::size_t{v} * camera_.width + u];
  }
  std::size_t tile_of(Index u, Index v) const {
    return std::size_t{v / tile} * ranges_.columns + u / tile;
  }
  Eigen::Vector3f ray(Index u, Index v) const { return {ray_x_[u], ray_y_[v], 1.0F}; }

  void cast_corners(RayCaster& caster, Index row) const {
    const Index v = corner(row, camera_.height);
    if (row > 0 && v == corner(row - 1, camera_.height)) return;
    for (Index column = 0; column <= ranges_.columns; ++column) {
      const Index u = corner(column, camera_.width);
      const std::size_t at = tile_of(u, v);
      if (ranges_.farthest[at] == 0.0F) continue;
      pixel(u, v) = caster.cast(ray(u, v), ranges_.nearest[at], ranges_.farthest[at]);
    }
  }

  void cast_tiles(RayCaster& caster, Index row) const {
    const Index top = row * tile, bottom = corner(row + 1, camera_.height);
    for (Index column = 0; column < ranges_.columns; ++column) {
      const Index left = column * tile, right = corner(column + 1, camera_.width);
      const std::size_t at = std::size_t{row} * ranges_.columns + column;
      if (ranges_.farthest[at] == 0.0F) continue;
      const float start = start_of(left, right, top, bottom);
      for (Index v = top; v < std::min(camera_.height, top + tile); ++v) {
        for (Index u = left; u < std::min(camera_.width, left + tile); ++u) {
          if ((u == left || u == right) && (v == top || v == bottom)) continue;
          pixel(u, v) = cast_between(caster, ray(u, v), start, at);
        }
      }
    }
  }

  /// A depth in front of the surface at the corners of a tile, 0 if they show different ones. [m]
  float start_of(Index left, Index right, Index top, Index bottom) const {
    const float depths[4] = {pixel(left, top).depth, pixel(right, top).depth,
                             pixel(left, bottom).depth, pixel(right, bottom).depth};
    const auto [least, most] = std::minmax_element(depths, depths + 4);
    return *least > 0.0F && *most - *least < 4.0F * band_ ? *least - band_ : 0.0F;
  }

  /// Starts at `start` if the surface is found from there, else at the nearest block.
  SurfacePixel cast_between(RayCaster& caster, const Eigen::Vector3f& ray, float start,
                            std::size_t at) const {
    const float nearest = ranges_.nearest[at], farthest = ranges_.farthest[at];
    if (start > nearest) {
      const SurfacePixel shown = caster.cast(ray, start, farthest);
      if (shown.depth > 0.0F) return shown;
    }
    return caster.cast(ray, nearest, farthest);
  }

  const TsdfVolume& volume_;
  ModelView& view_;
  const CameraIntrinsics& camera_;
  DepthRanges ranges_;
  float band_;  ///< [m]
  std::vector<float> ray_x_, ray_y_;
};

}  // namespace

ModelView cast_model_view(const TsdfVolume& volume, const CameraIntrinsics& camera,
                          const Eigen::Isometry3d& T_world_camera) {
  ModelView view{{camera, std::vector<SurfacePixel>(camera.pixels())}, T_world_camera};
  if (T_world_camera.matrix().allFinite() && !volume.empty()) ViewCaster(volume, view).cast();
  return view;
}

}  // namespace symscene
