#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sensor_models.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

/// A patch of the surface around a pixel, in the camera's frame.
struct LitPatch {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;
  double area = 0.0;  // [m²]
};

/// The error by light that reaches a pixel by one other surface (Fuchs 2010), on a coarse grid.
class Multipath {
 public:
  Multipath(const SensorFrame& frame, const CameraIntrinsics& camera, double albedo)
      : columns_(camera.width / step), rows_(camera.height / step) {
    errors_.assign(std::size_t{columns_} * rows_, 0.0);
    if (albedo == 0.0) return;
    std::vector<std::optional<LitPatch>> patches;
    for (Index row = 0; row < rows_; ++row) {
      for (Index column = 0; column < columns_; ++column)
        patches.push_back(patch_at(frame, camera, column * step + step / 2, row * step + step / 2));
    }
    for (std::size_t i = 0; i < patches.size(); ++i) {
      if (patches[i]) errors_[i] = error_at(*patches[i], patches, albedo);
    }
  }

  /// Error of the depth. [m]
  double at(Index u, Index v) const {
    if (errors_.empty()) return 0.0;
    const double x = std::clamp((u - step / 2.0) / step, 0.0, columns_ - 1.0);
    const double y = std::clamp((v - step / 2.0) / step, 0.0, rows_ - 1.0);
    const auto column = static_cast<Index>(x), row = static_cast<Index>(y);
    const Index right = std::min(column + 1, columns_ - 1), below = std::min(row + 1, rows_ - 1);
    const double fx = x - column, fy = y - row;
    return (1 - fy) * ((1 - fx) * value(column, row) + fx * value(right, row)) +
           fy * ((1 - fx) * value(column, below) + fx * value(right, below));
  }

 private:
  static constexpr Index step = 16;  // [px]

  double value(Index column, Index row) const {
    return errors_[std::size_t{row} * columns_ + column];
  }

  static std::optional<LitPatch> patch_at(const SensorFrame& frame, const CameraIntrinsics& camera,
                                          Index u, Index v) {
    constexpr Index reach = 3;
    if (u < reach || v < reach || u + reach >= camera.width || v + reach >= camera.height)
      return std::nullopt;
    const auto point = [&](Index column, Index row) -> Eigen::Vector3d {
      return frame.depth[std::size_t{row} * camera.width + column] * camera.ray(column, row);
    };
    const Eigen::Vector3d right = point(u + reach, v) - point(u - reach, v);
    const Eigen::Vector3d down = point(u, v + reach) - point(u, v - reach);
    const Eigen::Vector3d middle = point(u, v);
    const double cosine = frame.cosines[std::size_t{v} * camera.width + u];
    const double width = 2.0 * reach * middle.z() / camera.fx;
    const bool is_smooth = std::max(right.norm(), down.norm()) < 5.0 * width;
    if (!(middle.z() > 0.0) || !is_smooth || cosine < 0.1) return std::nullopt;
    Eigen::Vector3d normal = right.cross(down).normalized();
    if (normal.dot(middle) > 0.0) normal = -normal;
    const double pixel_width = middle.z() * step / camera.fx;
    return LitPatch{middle, normal, pixel_width * pixel_width / cosine};
  }

  /// Mean excess of the ways by all other patches, weighted with the light that takes them.
  static double error_at(const LitPatch& seen, const std::vector<std::optional<LitPatch>>& patches,
                         double albedo) {
    double light = 1.0, excess = 0.0;
    for (const std::optional<LitPatch>& other : patches) {
      if (!other) continue;
      const Eigen::Vector3d way = seen.point - other->point;
      const double length = way.norm();
      const double out = other->normal.dot(way), in = -seen.normal.dot(way);
      if (length == 0.0 || out <= 0.0 || in <= 0.0) continue;
      const double lit = std::max(0.0, -other->normal.dot(other->point.normalized()));
      const double facing = std::max(0.1, -seen.normal.dot(seen.point.normalized()));
      const double squared = std::max(length * length, other->area);
      const double share = albedo * lit / facing * other->area * (out / length) * (in / length) /
                           (std::numbers::pi * squared);
      light += share;
      excess += share * 0.5 * (other->point.norm() + length - seen.point.norm());
    }
    return std::max(0.0, excess / light);
  }

  Index columns_;
  Index rows_;
  std::vector<double> errors_;
};

/// The nearest and the farthest pixel around a pixel at a depth edge.
struct EdgeSides {
  std::size_t near = 0;
  std::size_t far = 0;
};

std::optional<EdgeSides> edge_at(const SensorFrame& frame, const CameraIntrinsics& camera, Index u,
                                 Index v, double edge_step) {
  if (u == 0 || v == 0 || u + 1 == camera.width || v + 1 == camera.height) return std::nullopt;
  const std::size_t pixel = std::size_t{v} * camera.width + u;
  if (frame.depth[pixel] <= 0.0F) return std::nullopt;
  EdgeSides sides{pixel, pixel};
  for (const std::size_t other :
       {pixel - 1, pixel + 1, pixel - camera.width, pixel + camera.width}) {
    if (frame.depth[other] <= 0.0F) continue;
    if (frame.depth[other] < frame.depth[sides.near]) sides.near = other;
    if (frame.depth[other] > frame.depth[sides.far]) sides.far = other;
  }
  if (frame.depth[sides.far] - frame.depth[sides.near] <= edge_step) return std::nullopt;
  return sides;
}

}  // namespace

SensorFrame time_of_flight_frame(const SensorFrame& exact, const CameraIntrinsics& camera,
                                 const SensorNoiseOptions& options, Random random) {
  const TimeOfFlightNoiseOptions& tof = options.tof;
  SensorFrame noisy = exact;
  const Multipath multipath(exact, camera, tof.multipath);
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const std::size_t pixel = std::size_t{v} * camera.width + u;
      std::size_t source = pixel;
      double z = exact.depth[pixel];
      const auto edge = edge_at(exact, camera, u, v, options.edge_step);
      if (edge && random.chance(tof.flying)) {
        const double near_share = random.uniform();
        source = near_share > 0.5 ? edge->near : edge->far;
        z = near_share * exact.depth[edge->near] + (1.0 - near_share) * exact.depth[edge->far];
      }
      const double amplitude =
          z > 0.0 ? reflectance(exact, source) * exact.cosines[source] / (z * z) : 0.0;
      const double growth =
          std::sqrt(std::max(1.0, tof.full_amplitude / std::max(amplitude, 1e-6)));
      z += multipath.at(u, v) + tof.deviation * growth * random.normal();
      set_pixel(noisy, pixel, exact, source, z);
      if (amplitude < std::max(tof.min_amplitude, 1e-6) || !(z > 0.0) || z >= options.max_depth ||
          random.chance(grazing_loss(exact, source, options)))
        clear_pixel(noisy, pixel);
    }
  }
  return noisy;
}

}  // namespace symscene
