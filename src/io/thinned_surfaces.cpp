#include "io/thinned_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "core/mesh_thinning.hpp"
#include "core/parallel.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

constexpr Index fewest_triangles = 60;
constexpr float cell_of_diagonal = 1e-3F;  // smallest cell, by the diagonal of a surface

double distance_to_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b) {
  const Eigen::Vector3d way = b - a;
  const double length = way.squaredNorm();
  const double along = length > 0.0 ? std::clamp((point - a).dot(way) / length, 0.0, 1.0) : 0.0;
  return (point - a - along * way).norm();
}

/// The triangles at each vertex of a mesh.
std::vector<std::vector<Eigen::Index>> triangles_at_vertices(const TriangleMesh& mesh) {
  std::vector<std::vector<Eigen::Index>> at(static_cast<std::size_t>(mesh.vertices.rows()));
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (Eigen::Index k = 0; k < 3; ++k) at[mesh.triangles(t, k)].push_back(t);
  return at;
}

/// The vertices that triangles use: thinning leaves others behind.
PointIndices used_vertices(const std::vector<std::vector<Eigen::Index>>& triangles) {
  PointIndices used;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (!triangles[i].empty()) used.push_back(static_cast<Index>(i));
  return used;
}

/// A bound on the distance of the vertices of `surface` from `thinned`: that to the triangles at
/// the thinned surface's nearest vertex.
double distance_bound(const TriangleMesh& surface, const TriangleMesh& thinned) {
  const auto around = triangles_at_vertices(thinned);
  const PointIndices used = used_vertices(around);
  if (used.empty()) return std::numeric_limits<double>::infinity();
  const float diagonal = bounding_box(surface.vertices).extent().norm();
  const CellList vertices(select({thinned.vertices, {}, {}}, used).positions, 0.05F * diagonal);
  const auto corner = [&](Eigen::Index t, Eigen::Index k) -> Eigen::Vector3d {
    return thinned.vertices.row(thinned.triangles(t, k)).transpose().cast<double>();
  };
  double greatest = 0.0;
  for (Eigen::Index i = 0; i < surface.vertices.rows(); ++i) {
    const Eigen::Vector3f vertex = surface.vertices.row(i).transpose();
    const Index nearest = used[vertices.nearest(vertex, 2.0F * diagonal).first];
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Index t : around[nearest])
      least = std::min(least, distance_to_triangle(vertex.cast<double>(), corner(t, 0),
                                                   corner(t, 1), corner(t, 2)));
    greatest = std::max(greatest, least);
  }
  return greatest;
}

}  // namespace

double distance_to_triangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                            const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const auto is_inside = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return normal.dot((to - from).cross(point - from)) >= 0.0;
  };
  if (normal.norm() > 0.0 && is_inside(a, b) && is_inside(b, c) && is_inside(c, a))
    return std::abs((point - a).dot(normal)) / normal.norm();
  return std::min({distance_to_segment(point, a, b), distance_to_segment(point, b, c),
                   distance_to_segment(point, c, a)});
}

ThinnedSurfaces thinned_surfaces(std::span<const TriangleMesh> surfaces, Index max_triangles) {
  const auto count = static_cast<Index>(std::max<std::size_t>(surfaces.size(), 1));
  const Index share = std::max(fewest_triangles, max_triangles / count);
  ThinnedSurfaces thinned;
  thinned.meshes.resize(surfaces.size());
  std::vector<double> errors(surfaces.size());
  parallel_for_each(surfaces.size(), [&](std::size_t i) {
    const TriangleMesh& surface = surfaces[i];
    thinned.meshes[i] = surface;
    if (surface.triangles.rows() <= share) return;
    const float diagonal = bounding_box(surface.vertices).extent().norm();
    thinned.meshes[i] = thin(surface, share, cell_of_diagonal * diagonal);
    errors[i] = distance_bound(surface, thinned.meshes[i]);
  });
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    thinned.triangles += static_cast<std::size_t>(thinned.meshes[i].triangles.rows());
    thinned.error = std::max(thinned.error, errors[i]);
  }
  return thinned;
}

}  // namespace symscene
