#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/point_cloud.hpp"

namespace symscene::testing {

inline constexpr std::uint32_t seeds[] = {1, 2, 3, 4, 5};

inline Eigen::Vector3d random_vector(std::mt19937& generator, double size = 1.0) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  const double x = coordinate(generator);
  const double y = coordinate(generator);
  const double z = coordinate(generator);
  return {x, y, z};
}

inline Eigen::Vector3d random_direction(std::mt19937& generator) {
  Eigen::Vector3d v = random_vector(generator);
  while (v.norm() < 0.1 || v.norm() > 1.0) v = random_vector(generator);
  return v.normalized();
}

inline Eigen::Isometry3d random_motion(std::mt19937& generator) {
  std::uniform_real_distribution<double> angle(-3.0, 3.0);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() =
      Eigen::AngleAxisd(angle(generator), random_direction(generator)).toRotationMatrix();
  motion.translation() = random_vector(generator, 2.0);
  return motion;
}

inline Points random_points(std::uint32_t seed, Eigen::Index count, double size = 0.1) {
  std::mt19937 generator(seed);
  Points points(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    points.row(i) = random_vector(generator, size).cast<float>().transpose();
  }
  return points;
}

/// Random clouds and the degenerate ones: empty, one point, two, duplicates, collinear, a lattice.
inline std::vector<std::pair<const char*, Points>> clouds_of_all_kinds() {
  std::vector<std::pair<const char*, Points>> clouds;
  for (const std::uint32_t seed : seeds) clouds.emplace_back("random", random_points(seed, 700));
  clouds.emplace_back("empty", Points(0, 3));
  clouds.emplace_back("one point", random_points(6, 1));
  clouds.emplace_back("two points", random_points(7, 2));
  clouds.emplace_back("duplicates", random_points(8, 1).replicate(60, 1));
  clouds.emplace_back("pairs of duplicates", random_points(9, 90).replicate(2, 1));
  Points line = Points::Zero(200, 3);
  for (Eigen::Index i = 0; i < line.rows(); ++i) line(i, 1) = 0.003F * static_cast<float>(i % 97);
  clouds.emplace_back("collinear", line);
  Points lattice(1000, 3);
  for (Eigen::Index i = 0; i < lattice.rows(); ++i) {
    lattice.row(i) = 0.005F * Eigen::RowVector3f(static_cast<float>(i % 10) + 0.3F,
                                                 static_cast<float>(i / 10 % 10) - 4.7F,
                                                 static_cast<float>(i / 100) + 100.1F);
  }
  clouds.emplace_back("lattice", lattice);
  return clouds;
}

}  // namespace symscene::testing
