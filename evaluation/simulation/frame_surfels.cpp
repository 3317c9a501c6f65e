#include <cmath>

#include <Eigen/Cholesky>

#include "surfels.hpp"

namespace symscene {
namespace {

/// Makes surfels of the pixels of one frame and rejects flying pixels at depth edges.
class FrameReader {
 public:
  FrameReader(const SensorFrame& frame, const CameraIntrinsics& camera,
              const CloudFusionOptions& options)
      : frame_(frame), camera_(camera), options_(options) {}

  std::size_t pixel(Index u, Index v) const { return std::size_t{v} * camera_.width + u; }

  /// Whether the depth of a neighbour differs so much that the pixel may mix two surfaces.
  bool may_fly(Index u, Index v) const {
    const float z = frame_.depth[pixel(u, v)];
    for (Index y = v - 1; y <= v + 1; ++y) {
      for (Index x = u - 1; x <= u + 1; ++x) {
        const float other = frame_.depth[pixel(x, y)];
        if (other > 0.0F && std::abs(other - z) > options_.edge_step) return true;
      }
    }
    return false;
  }

  /// The normal that faces the camera, from a least-squares plane over a window. A plane is linear
  /// in inverse depth: n · x = d with x = z ray gives 1/z = (n/d) · ray.
  bool fit_normal(Index u, Index v, Eigen::Vector3d& normal) const {
    const auto r = static_cast<Index>(options_.normal_radius);
    const double z = frame_.depth[pixel(u, v)];
    const double gate = options_.edge_step * (1.0 + 0.5 * r);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    int count = 0;
    for (Index y = v - r; y <= v + r; ++y) {
      for (Index x = u - r; x <= u + r; ++x) {
        const double depth = frame_.depth[pixel(x, y)];
        if (depth <= 0.0 || std::abs(depth - z) > gate) continue;
        // Offsets from the centre keep the sums well conditioned.
        const Eigen::Vector3d row(static_cast<double>(x) - u, static_cast<double>(y) - v, 1.0);
        sum.noalias() += row * row.transpose();
        right += row / depth;
        ++count;
      }
    }
    const auto window = static_cast<int>((2 * r + 1) * (2 * r + 1));
    if (3 * count < window) return false;
    const Eigen::Vector3d fit = sum.ldlt().solve(right);
    const Eigen::Vector3d ray = camera_.ray(u, v);
    const double a = fit[0] * camera_.fx;
    const double b = fit[1] * camera_.fy;
    normal = -Eigen::Vector3d(a, b, fit[2] - a * ray.x() - b * ray.y()).normalized();
    return normal.allFinite() && normal.dot(ray) < 0.0;
  }

 private:
  const SensorFrame& frame_;
  const CameraIntrinsics& camera_;
  const CloudFusionOptions& options_;
};

bool contains(const OrientedBox& box, const Eigen::Vector3d& point_box) {
  return (point_box.array() >= box.min.array()).all() &&
         (point_box.array() <= box.max.array()).all();
}

}  // namespace

std::vector<Surfel> frame_surfels(const SensorFrame& frame, std::size_t frame_index,
                                  const CameraIntrinsics& camera, const OrientedBox& region,
                                  const CloudFusionOptions& options) {
  const FrameReader reader(frame, camera, options);
  const Eigen::Isometry3d T_box_camera = region.T_world_box.inverse() * frame.T_world_camera;
  std::vector<Surfel> surfels;
  const auto border = static_cast<Index>(options.normal_radius);
  for (Index v = border; v + border < camera.height; ++v) {
    for (Index u = border; u + border < camera.width; ++u) {
      const std::size_t pixel = reader.pixel(u, v);
      const double z = frame.depth[pixel];
      if (z <= 0.0) continue;
      const Eigen::Vector3d point = z * camera.ray(u, v);
      Eigen::Vector3d normal;
      if (!contains(region, T_box_camera * point) || reader.may_fly(u, v) ||
          !reader.fit_normal(u, v, normal)) {
        continue;
      }
      // The error of the depth grows with its square, and with the slant of the surface.
      const double weight = -normal.dot(point.normalized()) / (z * z);
      Surfel surfel;
      surfel.position = (frame.T_world_camera * point).cast<float>();
      surfel.normal = (frame.T_world_camera.linear() * normal).cast<float>();
      surfel.color = frame.colors.row(static_cast<Eigen::Index>(pixel)).transpose().cast<float>();
      surfel.weight = static_cast<float>(weight);
      surfel.object = frame.objects[pixel];
      surfel.frames = std::uint64_t{1} << frame_index;
      surfels.push_back(surfel);
    }
  }
  return surfels;
}

}  // namespace symscene
