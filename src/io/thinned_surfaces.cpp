#include "io/thinned_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

double area_of(const TriangleMesh& mesh) {
  double doubled = 0.0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](Eigen::Index k) -> Eigen::Vector3d {
      return mesh.vertices.row(mesh.triangles(t, k)).transpose().cast<double>();
    };
    doubled += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  }
  return 0.5 * doubled;
}

/// The vertices that triangles use: thinning leaves others behind.
PointIndices used_vertices(const std::vector<std::vector<Eigen::Index>>& triangles) {
  PointIndices used;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (!triangles[i].empty()) used.push_back(static_cast<Index>(i));
  return used;
}

/// Distances of points from the triangles of a mesh.
class MeshDistance {
 public:
  /// `mesh` is kept. Its box has about the diagonal `size` [m].
  MeshDistance(const TriangleMesh& mesh, float size)
      : mesh_(mesh),
        at_(triangles_at_vertices(mesh)),
        used_(used_vertices(at_)),
        vertices_(select({mesh.vertices, {}, {}}, used_).positions, 0.05F * size),
        size_(size) {}

  /// That from the triangles at the nearest vertex: not less than the true distance.
  double bound(const Eigen::Vector3f& point) const {
    const Index nearest = vertices_.nearest(point, 2.0F * size_).first;
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Index t : at_[used_[nearest]]) least = std::min(least, distance(point, t));
    return least;
  }
  double exact(const Eigen::Vector3f& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index t = 0; t < mesh_.triangles.rows(); ++t)
      least = std::min(least, distance(point, t));
    return least;
  }

 private:
  double distance(const Eigen::Vector3f& point, Eigen::Index t) const {
    const auto corner = [&](Eigen::Index k) -> Eigen::Vector3d {
      return mesh_.vertices.row(mesh_.triangles(t, k)).transpose().cast<double>();
    };
    return distance_to_triangle(point.cast<double>(), corner(0), corner(1), corner(2));
  }

  const TriangleMesh& mesh_;
  std::vector<std::vector<Eigen::Index>> at_;
  PointIndices used_;
  CellList vertices_;
  float size_;
};

struct ThinningError {
  double usual = 0.0;  ///< bound that 99 % of the vertices keep [m]
  double greatest = 0.0;
};

/// Distances of the vertices of `surface` from `thinned`. Those with the greatest bounds are
/// measured first, so that few are.
ThinningError thinning_error(const TriangleMesh& surface, const TriangleMesh& thinned) {
  constexpr double none = std::numeric_limits<double>::infinity();
  if (thinned.triangles.rows() == 0) return {none, none};
  const MeshDistance distance(thinned, bounding_box(surface.vertices).extent().norm());
  std::vector<std::pair<double, Eigen::Index>> bounds;
  for (Eigen::Index i = 0; i < surface.vertices.rows(); ++i)
    bounds.emplace_back(distance.bound(surface.vertices.row(i).transpose()), i);
  std::sort(bounds.rbegin(), bounds.rend());
  ThinningError error{bounds[bounds.size() / 100].first, 0.0};
  for (const auto& [bound, vertex] : bounds) {
    if (bound <= error.greatest) break;
    error.greatest =
        std::max(error.greatest, distance.exact(surface.vertices.row(vertex).transpose()));
  }
  return error;
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
  double area = 0.0;
  for (const TriangleMesh& surface : surfaces) area += area_of(surface);
  ThinnedSurfaces thinned;
  thinned.meshes.resize(surfaces.size());
  std::vector<ThinningError> errors(surfaces.size());
  parallel_for_each(surfaces.size(), [&](std::size_t i) {
    const TriangleMesh& surface = surfaces[i];
    thinned.meshes[i] = surface;
    const double part = area > 0.0 ? area_of(surface) / area : 0.0;
    const Index share = std::max(fewest_triangles, static_cast<Index>(part * max_triangles));
    if (surface.triangles.rows() <= share) return;
    const float diagonal = bounding_box(surface.vertices).extent().norm();
    thinned.meshes[i] = thin(surface, share, cell_of_diagonal * diagonal);
    errors[i] = thinning_error(surface, thinned.meshes[i]);
  });
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    thinned.triangles += static_cast<std::size_t>(thinned.meshes[i].triangles.rows());
    thinned.error = std::max(thinned.error, errors[i].greatest);
    thinned.usual_error = std::max(thinned.usual_error, errors[i].usual);
  }
  return thinned;
}

}  // namespace symscene
