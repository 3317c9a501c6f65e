#pragma once

#include <array>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "core/looking_at.hpp"
#include "reconstruction/surface_extraction.hpp"

/// Bodies whose depth images are known in closed form, and cameras that look at them.
namespace symscene::testing {

/// The smallest t > 0 at which the ray o + t d meets a body, and infinity where it does not.
using Body = std::function<double(const Eigen::Vector3d& o, const Eigen::Vector3d& d)>;
using Bodies = std::vector<Body>;

/// Depth noise of a structured-light camera: sigma = axial_noise z². [1/m]
constexpr double axial_noise = 1.425e-3;

inline CameraIntrinsics half_vga() { return {320, 240, 262.5, 262.5, 159.5, 119.5}; }

inline Eigen::Vector3d normal_of(const SurfacePixel& pixel) {
  return Eigen::Vector3f(pixel.nx, pixel.ny, pixel.nz).cast<double>();
}

constexpr double no_hit = std::numeric_limits<double>::infinity();

inline Body plane(const Eigen::Vector3d& normal, double offset) {
  return [=](const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
    const double t = -(normal.dot(o) + offset) / normal.dot(d);
    return t > 0.0 ? t : no_hit;
  };
}

inline Body sphere(const Eigen::Vector3d& center, double radius) {
  return [=](const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
    const Eigen::Vector3d c = o - center;
    const double a = d.squaredNorm(), b = c.dot(d);
    const double root = b * b - a * (c.squaredNorm() - radius * radius);
    if (root < 0.0) return no_hit;
    const double t = (-b - std::sqrt(root)) / a;
    return t > 0.0 ? t : no_hit;
  };
}

/// A box about the origin of its frame.
inline Body box(const Eigen::Isometry3d& T_world_box, const Eigen::Vector3d& half) {
  const Eigen::Isometry3d T_box_world = T_world_box.inverse();
  return [=](const Eigen::Vector3d& o_world, const Eigen::Vector3d& d_world) {
    const Eigen::Vector3d o = T_box_world * o_world, d = T_box_world.linear() * d_world;
    double near = 0.0, far = no_hit;
    for (int k = 0; k < 3; ++k) {
      if (d[k] == 0.0) {
        if (std::abs(o[k]) > half[k]) return no_hit;
        continue;
      }
      const double a = (-half[k] - o[k]) / d[k], b = (half[k] - o[k]) / d[k];
      near = std::max(near, std::min(a, b));
      far = std::min(far, std::max(a, b));
    }
    return near > 0.0 && near <= far ? near : no_hit;
  };
}

/// An ellipsoid about the origin of its frame.
inline Body ellipsoid(const Eigen::Isometry3d& T_world_body, const Eigen::Vector3d& radii) {
  const Eigen::Isometry3d T_body_world = T_world_body.inverse();
  const Body unit = sphere(Eigen::Vector3d::Zero(), 1.0);
  return [=](const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
    return unit((T_body_world * o).cwiseQuotient(radii),
                (T_body_world.linear() * d).cwiseQuotient(radii));
  };
}

/// A camera of small images.
inline CameraIntrinsics small_camera() { return {160, 120, 140.0, 141.0, 79.3, 59.8}; }

/// The depth of the nearest body along a pixel's ray, 0 where there is none.
inline double depth_at(const Bodies& bodies, const CameraIntrinsics& camera,
                       const Eigen::Isometry3d& T_world_camera, double u, double v) {
  const Eigen::Vector3d ray = T_world_camera.linear() * camera.ray(u, v);
  double depth = no_hit;
  for (const Body& body : bodies) {
    depth = std::min(depth, body(T_world_camera.translation(), ray));
  }
  return depth < no_hit ? depth : 0.0;
}

inline DepthFrame render(const Bodies& bodies, const CameraIntrinsics& camera,
                         const Eigen::Isometry3d& T_world_camera) {
  DepthFrame frame;
  frame.depth.reserve(camera.pixels());
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      frame.depth.push_back(static_cast<float>(depth_at(bodies, camera, T_world_camera, u, v)));
    }
  }
  return frame;
}

inline DepthFrame flat_frame(const CameraIntrinsics& camera, float depth) {
  return {0.0, std::vector<float>(camera.pixels(), depth), {}};
}

/// Every pixel of one colour.
inline void paint(DepthFrame& frame, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  frame.colors.resize(static_cast<Eigen::Index>(frame.depth.size()), 3);
  frame.colors.rowwise() = Eigen::Matrix<std::uint8_t, 1, 3>(red, green, blue);
}

/// A camera at `eye` that looks at `target`, upright as far as that goes: z is up.
inline Eigen::Isometry3d look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  const Eigen::Vector3d forward = (target - eye).normalized();
  const bool steep = std::abs(forward.z()) > 0.99;
  return looking_along(eye, forward, steep ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ());
}

/// Cameras spread evenly over a sphere (a Fibonacci lattice) that look at its centre.
inline std::vector<Eigen::Isometry3d> views_around(const Eigen::Vector3d& center, double distance,
                                                   int count) {
  std::vector<Eigen::Isometry3d> views;
  for (int k = 0; k < count; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / count, angle = 2.39996322972865332 * k;
    const double r = std::sqrt(1.0 - z * z);
    const Eigen::Vector3d direction(r * std::cos(angle), r * std::sin(angle), z);
    views.push_back(look_at(center + distance * direction, center));
  }
  return views;
}

inline Eigen::Isometry3d motion(const Eigen::Vector3d& rotation_vector,
                                const Eigen::Vector3d& translation) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const double angle = rotation_vector.norm();
  if (angle > 0.0) T.linear() = Eigen::AngleAxisd(angle, rotation_vector / angle).matrix();
  T.translation() = translation;
  return T;
}

inline Eigen::Isometry3d random_pose(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  Eigen::Quaterniond q(uniform(random), uniform(random), uniform(random), uniform(random));
  pose.linear() = q.normalized().toRotationMatrix();
  for (int k = 0; k < 3; ++k) pose.translation()[k] = reach * uniform(random);
  return pose;
}

/// A table in z = 0 with boxes and balls on it, unlike from every side.
inline Bodies tabletop() {
  const auto block = [](double turn, const Eigen::Vector3d& place, const Eigen::Vector3d& half) {
    return box(motion({0, 0, turn}, place), half);
  };
  return {plane(Eigen::Vector3d::UnitZ(), 0.0),
          block(0.3, {0.08, 0.05, 0.07}, {0.05, 0.03, 0.07}),
          block(-0.7, {-0.13, 0.08, 0.04}, {0.06, 0.04, 0.04}),
          block(1.2, {0.02, -0.16, 0.03}, {0.08, 0.03, 0.03}),
          sphere({-0.1, -0.08, 0.05}, 0.05),
          sphere({0.2, -0.08, 0.04}, 0.06)};
}

/// Where a camera stands that goes around the tabletop. [rad]
inline Eigen::Isometry3d around_table(double angle) {
  return look_at({0.55 * std::cos(angle), 0.55 * std::sin(angle), 0.5}, {0.0, 0.0, 0.03});
}

inline void fuse(TsdfVolume& volume, const Bodies& bodies, const CameraIntrinsics& camera,
                 const Eigen::Isometry3d& T_world_camera) {
  const DepthFrame frame = render(bodies, camera, T_world_camera);
  volume.integrate(prepare_measurement(frame, camera, {}), T_world_camera);
}

/// A volume that has seen bodies around a centre from everywhere.
inline TsdfVolume seen_from_everywhere(const Bodies& bodies, const Eigen::Vector3d& center,
                                       int views, const TsdfOptions& options = {}) {
  TsdfVolume volume(options);
  for (const Eigen::Isometry3d& view : views_around(center, 0.5, views)) {
    fuse(volume, bodies, small_camera(), view);
  }
  return volume;
}

inline bool same(const TriangleMesh& a, const TriangleMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles && a.normals == b.normals &&
         a.colors == b.colors;
}

inline bool same(const SurfaceImage& a, const SurfaceImage& b) {
  return std::equal(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), b.pixels.end(),
                    [](const SurfacePixel& p, const SurfacePixel& q) {
                      return p.depth == q.depth && p.nx == q.nx && p.ny == q.ny && p.nz == q.nz;
                    });
}

inline bool same(const TsdfVolume& a, const TsdfVolume& b) {
  if (a.index().blocks() != b.index().blocks()) return false;
  for (std::size_t slot = 0; slot < a.index().size(); ++slot) {
    if (a.block(slot).distance != b.block(slot).distance ||
        a.block(slot).weight != b.block(slot).weight ||
        a.near_surface(slot) != b.near_surface(slot)) {
      return false;
    }
    if ((a.colors(slot) == nullptr) != (b.colors(slot) == nullptr)) return false;
    if (a.colors(slot) != nullptr && a.colors(slot)->rgbw != b.colors(slot)->rgbw) return false;
  }
  return true;
}

/// Calls visit(centre, distance, weight) for the voxels of a volume that were seen, in metres and
/// frontal views at 1 m.
template <class Visit>
void for_each_seen_voxel(const TsdfVolume& volume, const Visit& visit) {
  for (std::size_t slot = 0; slot < volume.index().size(); ++slot) {
    const TsdfBlock& block = volume.block(slot);
    const Eigen::Vector3i first = volume.index().blocks()[slot] * TsdfBlock::edge;
    for (int i = 0; i < TsdfBlock::voxels; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (block.weight[at] == 0) continue;
      const Eigen::Vector3d voxel =
          (first + Eigen::Vector3i(i & 7, (i >> 3) & 7, i >> 6)).cast<double>();
      visit(Eigen::Vector3d((voxel.array() + 0.5) * volume.voxel_size()),
            static_cast<double>(volume.distance_unit()) * block.distance[at],
            block.weight[at] / double{Measurement::weight_units});
    }
  }
}

}  // namespace symscene::testing
