#include "simulation/shapes.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "mesh_builder.hpp"

namespace symscene {
namespace {

/// Welds the vertices of the grid of a box by their place in the lattice.
class BoxBuilder {
 public:
  BoxBuilder(const Eigen::Vector3d& size, double max_edge) : size_(size) {
    for (int axis = 0; axis < 3; ++axis) {
      cells_[axis] = std::max(1, static_cast<int>(std::ceil(size[axis] / max_edge)));
    }
  }

  /// The two faces across `axis`.
  void add_faces(int axis) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    for (const int side : {0, cells_[axis]}) {
      for (int i = 0; i < cells_[a]; ++i) {
        for (int j = 0; j < cells_[b]; ++j) {
          const auto corner = [&](int di, int dj) {
            Eigen::Vector3i lattice;
            lattice[axis] = side;
            lattice[a] = i + di;
            lattice[b] = j + dj;
            return vertex(lattice);
          };
          const Index v00 = corner(0, 0), v10 = corner(1, 0), v11 = corner(1, 1),
                      v01 = corner(0, 1);
          if (side == 0) {
            mesh_.add_quad(v00, v01, v11, v10);
          } else {
            mesh_.add_quad(v00, v10, v11, v01);
          }
        }
      }
    }
  }

  TriangleMesh take() { return mesh_.take(); }

 private:
  Index vertex(const Eigen::Vector3i& lattice) {
    const auto [entry, added] =
        vertices_.try_emplace({lattice.x(), lattice.y(), lattice.z()}, mesh_.vertex_count());
    if (added) {
      // Multiplied before it is divided, so that opposite vertices are exact mirror images.
      Eigen::Vector3d p;
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = size_[axis] * (2 * lattice[axis] - cells_[axis]) / (2 * cells_[axis]);
      }
      p.z() += 0.5 * size_.z();
      mesh_.add_vertex(p);
    }
    return entry->second;
  }

  Eigen::Vector3d size_;
  Eigen::Vector3i cells_;
  MeshBuilder mesh_;
  std::map<std::tuple<int, int, int>, Index> vertices_;
};

std::vector<ProfilePoint> subdivided(std::span<const ProfilePoint> profile, double max_edge) {
  std::vector<ProfilePoint> fine;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const ProfilePoint& a = profile[i];
    const ProfilePoint& b = profile[i + 1];
    const double length = std::hypot(b.radius - a.radius, b.height - a.height);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / max_edge)));
    for (int k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      fine.push_back({a.radius + t * (b.radius - a.radius), a.height + t * (b.height - a.height)});
    }
  }
  fine.push_back(profile.back());
  return fine;
}

/// A ring of vertices around the axis, or a single vertex on it.
struct VertexRing {
  Index first = 0;  ///< vertex
  bool is_point = false;
};

/// Triangles between two rings, at most one of which is a single vertex.
void add_band(MeshBuilder& mesh, const VertexRing& lower, const VertexRing& upper, Index segments) {
  for (Index s = 0; s < segments; ++s) {
    const Index next = (s + 1) % segments;
    if (lower.is_point) {
      mesh.add_triangle(lower.first, upper.first + next, upper.first + s);
    } else if (upper.is_point) {
      mesh.add_triangle(lower.first + s, lower.first + next, upper.first);
    } else {
      mesh.add_quad(lower.first + s, lower.first + next, upper.first + next, upper.first + s);
    }
  }
}

}  // namespace

TriangleMesh make_box(const Eigen::Vector3d& size, double max_edge) {
  BoxBuilder box(size, max_edge);
  for (int axis = 0; axis < 3; ++axis) box.add_faces(axis);
  return box.take();
}

TriangleMesh make_revolution(std::span<const ProfilePoint> profile, int segments, double max_edge) {
  const std::vector<ProfilePoint> fine = subdivided(profile, max_edge);
  const auto count = static_cast<Index>(segments);
  MeshBuilder mesh;
  std::vector<VertexRing> rings;
  for (const ProfilePoint& p : fine) {
    rings.push_back({mesh.vertex_count(), p.radius == 0.0});
    const int vertices = rings.back().is_point ? 1 : segments;
    for (int s = 0; s < vertices; ++s) {
      const double angle = 2.0 * std::numbers::pi * s / segments;
      mesh.add_vertex({p.radius * std::cos(angle), p.radius * std::sin(angle), p.height});
    }
  }
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) add_band(mesh, rings[i], rings[i + 1], count);
  return mesh.take();
}

Eigen::Vector3d volume_centroid(const TriangleMesh& mesh) {
  double volume = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(t, 0)).transpose().cast<double>();
    const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(t, 1)).transpose().cast<double>();
    const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(t, 2)).transpose().cast<double>();
    const double part = a.dot(b.cross(c));
    volume += part;
    moment += part * (a + b + c) / 4.0;
  }
  return moment / volume;
}

bool is_inside(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
  double solid_angle = 0.0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](int k) -> Eigen::Vector3d {
      return mesh.vertices.row(mesh.triangles(t, k)).transpose().cast<double>() - point;
    };
    const Eigen::Vector3d a = corner(0), b = corner(1), c = corner(2);
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    solid_angle += 2.0 * std::atan2(a.dot(b.cross(c)),
                                    la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return solid_angle > 2.0 * std::numbers::pi;
}

}  // namespace symscene
