#include "robots/solid_mesh.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/rigid_motion.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

constexpr int quarter_steps = 4;  // of a quarter of a circle, from a pole to the cylinder
constexpr Eigen::Index segments = 16;

/// Radius and height of a circle of vertices.
struct Ring {
  double radius, height;
};

/// From the lower pole to the upper one, both left out; a cylinder stands between two half spheres.
std::vector<Ring> rings_between_poles(double radius, double length) {
  std::vector<Ring> rings;
  const auto add = [&](double center, int step) {
    const double angle = 0.5 * std::numbers::pi * step / quarter_steps;
    rings.push_back({radius * std::cos(angle), center + radius * std::sin(angle)});
  };
  for (int step = 1 - quarter_steps; step <= 0; ++step) add(0.0, step);
  for (int step = length > 0.0 ? 0 : 1; step < quarter_steps; ++step) add(length, step);
  return rings;
}

/// Vertices: both poles, then those of the rings.
Points ring_vertices(const std::vector<Ring>& rings, double radius, double length) {
  Points vertices(2 + segments * static_cast<Eigen::Index>(rings.size()), 3);
  vertices.row(0) << 0.0F, 0.0F, static_cast<float>(-radius);
  vertices.row(1) << 0.0F, 0.0F, static_cast<float>(length + radius);
  Eigen::Index row = 2;
  for (const Ring& ring : rings) {
    for (Eigen::Index s = 0; s < segments; ++s) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(s) / segments;
      const Eigen::Vector3d vertex(ring.radius * std::cos(angle), ring.radius * std::sin(angle),
                                   ring.height);
      vertices.row(row++) = vertex.cast<float>().transpose();
    }
  }
  return vertices;
}

void add_triangles(std::size_t rings, TriangleMesh& mesh) {
  const auto count = static_cast<Index>(segments);
  const auto at = [&](std::size_t ring, Index s) {
    return 2 + static_cast<Index>(ring) * count + s % count;
  };
  mesh.triangles.resize(2 * segments * static_cast<Eigen::Index>(rings), 3);
  Eigen::Index row = 0;
  const auto add = [&](Index a, Index b, Index c) { mesh.triangles.row(row++) << a, b, c; };
  for (Index s = 0; s < count; ++s) {
    add(0, at(0, s + 1), at(0, s));
    add(1, at(rings - 1, s), at(rings - 1, s + 1));
    for (std::size_t r = 0; r + 1 < rings; ++r) {
      add(at(r, s), at(r, s + 1), at(r + 1, s + 1));
      add(at(r, s), at(r + 1, s + 1), at(r + 1, s));
    }
  }
}

}  // namespace

TriangleMesh box_mesh(const Eigen::AlignedBox3d& box) {
  TriangleMesh mesh;
  mesh.vertices.resize(8, 3);
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    mesh.vertices.row(i) = corner.cast<float>().transpose();
  }
  mesh.triangles.resize(12, 3);
  mesh.triangles << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6,
      0, 6, 2, 1, 3, 7, 1, 7, 5;
  return mesh;
}

TriangleMesh capsule_mesh(const Capsule& capsule) {
  const Eigen::Vector3d way = capsule.end - capsule.begin;
  const std::vector<Ring> rings = rings_between_poles(capsule.radius, way.norm());
  TriangleMesh mesh;
  mesh.vertices = ring_vertices(rings, capsule.radius, way.norm());
  add_triangles(rings.size(), mesh);
  Eigen::Isometry3d pose(Eigen::Translation3d(capsule.begin));
  pose.linear() = shortest_rotation(Eigen::Vector3d::UnitZ(), way);
  return transformed(std::move(mesh), pose);
}

}  // namespace symscene
