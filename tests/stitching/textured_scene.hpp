#pragma once

#include <gtest/gtest.h>

#include "core/looking_at.hpp"
#include "core/random.hpp"
#include "simulation/depth_renderer.hpp"
#include "simulation/shapes.hpp"
#include "symscene/simulation/sensor_noise.hpp"
#include "symscene/stitching/stitching.hpp"

/// A table with printed objects, seen by a noisy camera from known poses.
namespace symscene::testing {

inline const CameraIntrinsics camera{480, 360, 400.0, 400.0, 239.5, 179.5};

/// Blots of random shades about 1 cm in size, a function of the place.
inline Colors blots(const Points& vertices, std::uint64_t seed) {
  Colors colors(vertices.rows(), 3);
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) {
    std::uint64_t key = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      key = key * 4096 + static_cast<std::uint64_t>(vertices(i, axis) / 0.009F + 1000.0F);
    }
    Random random(seed, key);
    for (Eigen::Index c = 0; c < 3; ++c) {
      colors(i, c) = static_cast<std::uint8_t>(40 + random.below(200));
    }
  }
  return colors;
}

inline Colors plain(const Points& vertices) {
  return Colors::Constant(vertices.rows(), 3, std::uint8_t{128});
}

enum class Look { printed, plain };

/// Boxes and a vase on a slab of 1 m with its top at z = 0; `print` seeds their texture.
inline std::vector<TriangleMesh> furnished_table(Look look, std::uint64_t print) {
  const auto standing = [](TriangleMesh mesh, double x, double y, double z, double turn) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    T.translation() << x, y, z;
    return transformed(std::move(mesh), T);
  };
  const std::array<ProfilePoint, 5> vase{
      ProfilePoint{0.0, 0.0}, {0.05, 0.0}, {0.07, 0.07}, {0.04, 0.2}, {0.0, 0.2}};
  std::vector<TriangleMesh> meshes{
      standing(make_box({1.0, 1.0, 0.05}, 0.003), 0.0, 0.0, -0.05, 0.0),
      standing(make_box({0.12, 0.08, 0.2}, 0.003), 0.1, 0.05, 0.0, 0.5),
      standing(make_box({0.2, 0.1, 0.06}, 0.003), -0.12, -0.1, 0.0, -0.3),
      standing(make_revolution(vase, 128, 0.003), -0.1, 0.15, 0.0, 0.0)};
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    meshes[k].colors = look == Look::printed ? blots(meshes[k].vertices, 10 * print + k)
                                             : plain(meshes[k].vertices);
  }
  return meshes;
}

/// At 0.8 m from the middle of the table, at an azimuth and 40° above. [rad]
inline Eigen::Isometry3d view_from(double azimuth) {
  const double elevation = radians(40.0);
  const Eigen::Vector3d target(0.0, 0.0, 0.05);
  const Eigen::Vector3d away(std::cos(azimuth) * std::cos(elevation),
                             std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
  return looking_along(target + 0.8 * away, -away);
}

inline DepthFrame photograph(const DepthRenderer& renderer, const Eigen::Isometry3d& T_world_camera,
                             std::uint64_t seed) {
  const SensorFrame frame = add_sensor_noise(renderer.render(camera, T_world_camera), camera,
                                             SensorNoiseOptions{}, Random(seed));
  return {0.0, frame.depth, frame.colors};
}

/// Photographs from azimuths in degrees with their poses.
struct Photographs {
  std::vector<DepthFrame> frames;
  std::vector<Eigen::Isometry3d> truth;
};

inline Photographs photograph_table(const std::vector<double>& azimuths, Look look = Look::printed,
                                    std::uint64_t print = 1) {
  const std::vector<TriangleMesh> meshes = furnished_table(look, print);
  const DepthRenderer renderer(meshes);
  Photographs photographs;
  for (const double azimuth : azimuths) {
    photographs.truth.push_back(view_from(radians(azimuth)));
    photographs.frames.push_back(
        photograph(renderer, photographs.truth.back(), 7 + photographs.frames.size()));
  }
  return photographs;
}

/// The error of a pose.
struct PoseError {
  double distance = 0.0;  ///< [m]
  double angle = 0.0;     ///< [rad]
};
inline PoseError pose_error(const Eigen::Isometry3d& pose, const Eigen::Isometry3d& truth) {
  const Eigen::Isometry3d difference = truth.inverse() * pose;
  return {difference.translation().norm(), Eigen::AngleAxisd(difference.linear()).angle()};
}

}  // namespace symscene::testing
