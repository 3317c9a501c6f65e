#include "core/mesh_thinning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "core/vertex_normals.hpp"

namespace symscene {
namespace {

constexpr Index none = ~Index{0};

using Triangle = std::array<Index, 3>;

Triangle triangle_of(const TriangleMesh& mesh, Eigen::Index t) {
  return {mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)};
}

Eigen::Vector3d vector_of(const Points& points, Index i) {
  return points.row(i).transpose().cast<double>();
}

void set_triangles(TriangleMesh& mesh, const std::vector<Triangle>& triangles) {
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      mesh.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) = triangles[t][k];
    }
  }
}

std::vector<bool> vertices_inside(const TriangleMesh& mesh, const Ball& ball) {
  std::vector<bool> inside;
  inside.reserve(static_cast<std::size_t>(mesh.vertices.rows()));
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    // False where a coordinate is not a number.
    const float distance = (mesh.vertices.row(i).transpose() - ball.center).norm();
    inside.push_back(distance <= ball.radius && std::isfinite(distance));
  }
  return inside;
}

/// The submesh of these triangles.
TriangleMesh part(const TriangleMesh& mesh, std::vector<Triangle> triangles) {
  std::vector<Index> renamed(static_cast<std::size_t>(mesh.vertices.rows()), none);
  PointIndices used;
  for (Triangle& triangle : triangles) {
    for (Index& corner : triangle) {
      if (renamed[corner] == none) {
        renamed[corner] = static_cast<Index>(used.size());
        used.push_back(corner);
      }
      corner = renamed[corner];
    }
  }
  TriangleMesh result;
  result.vertices = mesh.vertices(used, Eigen::all);
  if (mesh.colors.rows() != 0) result.colors = mesh.colors(used, Eigen::all);
  if (mesh.normals.rows() != 0) result.normals = mesh.normals(used, Eigen::all);
  set_triangles(result, triangles);
  return result;
}

/// The vertices that are merged into one.
struct Cluster {
  Eigen::Vector3f facing;  ///< the normal of its first vertex
  Index other_side = none;
  double count = 0.0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // sums
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d color = Eigen::Vector3d::Zero();
};

class Clustering {
 public:
  Clustering(const TriangleMesh& mesh, float cell)
      : mesh_(mesh),
        normals_(mesh.normals.rows() != 0 ? mesh.normals : vertex_normals(mesh)),
        origin_(mesh.vertices.colwise().minCoeff().transpose()),
        cell_(cell) {
    for (Index i = 0; i < mesh.vertices.rows(); ++i) cluster_of_.push_back(add(i));
  }

  TriangleMesh result() const {
    TriangleMesh mesh;
    const auto size = static_cast<Eigen::Index>(clusters_.size());
    mesh.vertices.resize(size, 3);
    mesh.normals.resize(size, 3);
    if (mesh_.colors.rows() != 0) mesh.colors.resize(size, 3);
    for (Eigen::Index i = 0; i < size; ++i) {
      const Cluster& cluster = clusters_[static_cast<std::size_t>(i)];
      mesh.vertices.row(i) = (cluster.position / cluster.count).cast<float>().transpose();
      mesh.normals.row(i) = cluster.normal.normalized().cast<float>().transpose();
      if (mesh.colors.rows() == 0) continue;
      const Eigen::Vector3d color = (cluster.color / cluster.count).array().round();
      mesh.colors.row(i) = color.cast<std::uint8_t>().transpose();
    }
    set_triangles(mesh, triangles());
    return mesh;
  }

 private:
  std::uint64_t key(Index i) const {
    constexpr float most = (1 << 21) - 1;
    const Eigen::Vector3f step = (mesh_.vertices.row(i).transpose() - origin_) / cell_;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      key = key << 21 | static_cast<std::uint64_t>(std::min(step[axis], most));
    }
    return key;
  }

  Index create(const Eigen::Vector3f& normal) {
    clusters_.push_back({.facing = normal});
    return static_cast<Index>(clusters_.size() - 1);
  }

  /// The cluster of this cell on the side that the normal faces.
  Index find(std::uint64_t key, const Eigen::Vector3f& normal) {
    const auto [entry, is_new] = first_in_cell_.try_emplace(key, none);
    if (is_new) return entry->second = create(normal);
    const Index first = entry->second;
    if (clusters_[first].facing.dot(normal) >= 0.0F) return first;
    if (clusters_[first].other_side == none) {
      const Index other = create(normal);
      clusters_[first].other_side = other;
    }
    return clusters_[first].other_side;
  }

  Index add(Index i) {
    const Index index = find(key(i), normals_.row(i).transpose());
    Cluster& cluster = clusters_[index];
    cluster.count += 1.0;
    cluster.position += vector_of(mesh_.vertices, i);
    cluster.normal += vector_of(normals_, i);
    if (mesh_.colors.rows() != 0) {
      cluster.color += mesh_.colors.row(i).transpose().cast<double>();
    }
    return index;
  }

  /// The triangles that keep three different corners, each once.
  std::vector<Triangle> triangles() const {
    std::vector<Triangle> kept;
    for (Eigen::Index t = 0; t < mesh_.triangles.rows(); ++t) {
      Triangle triangle = triangle_of(mesh_, t);
      for (Index& corner : triangle) corner = cluster_of_[corner];
      const auto [a, b, c] = triangle;
      if (a == b || b == c || c == a) continue;
      // The smallest corner first, so that equal triangles are equal.
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                  triangle.end());
      kept.push_back(triangle);
    }
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    return kept;
  }

  const TriangleMesh& mesh_;
  Points normals_;
  Eigen::Vector3f origin_;
  float cell_;
  std::unordered_map<std::uint64_t, Index> first_in_cell_;
  std::vector<Cluster> clusters_;
  std::vector<Index> cluster_of_;
};

}  // namespace

TriangleMesh crop(const TriangleMesh& mesh, const Ball& ball) {
  const std::vector<bool> inside = vertices_inside(mesh, ball);
  std::vector<Triangle> kept;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Triangle triangle = triangle_of(mesh, t);
    if (std::all_of(triangle.begin(), triangle.end(), [&](Index i) { return inside[i]; })) {
      kept.push_back(triangle);
    }
  }
  return part(mesh, std::move(kept));
}

TriangleMesh cluster_vertices(const TriangleMesh& mesh, float cell) {
  if (mesh.vertices.rows() == 0) return mesh;
  return Clustering(mesh, cell).result();
}

TriangleMesh thin(const TriangleMesh& mesh, Index max_triangles, float smallest_cell) {
  if (mesh.triangles.rows() <= max_triangles) return mesh;
  TriangleMesh thinned = cluster_vertices(mesh, smallest_cell);
  for (float cell = smallest_cell; thinned.triangles.rows() > max_triangles;) {
    // The number of triangles falls with the square of the cell; the margin saves iterations.
    const auto excess = static_cast<double>(thinned.triangles.rows()) / max_triangles;
    cell *= static_cast<float>(1.02 * std::sqrt(excess));
    thinned = cluster_vertices(mesh, cell);
  }
  return thinned;
}

}  // namespace symscene
