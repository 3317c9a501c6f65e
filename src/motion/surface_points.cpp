#include "surface_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace symscene {
namespace {

using Corner = Eigen::Vector3f;

/// The corners of a triangle's equal parts with edges of at most `spacing`.
void append_triangle(const Corner& a, const Corner& b, const Corner& c, float spacing,
                     std::vector<Eigen::Vector3f>& points) {
  const float longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  const int n = std::max(1, static_cast<int>(std::ceil(longest / spacing)));
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      points.emplace_back(a + (static_cast<float>(i) * (b - a) + static_cast<float>(j) * (c - a)) /
                                  static_cast<float>(n));
    }
  }
}

/// A number per cube that is ordered as (x, y, z). Cubes beyond 2^20 from the origin share the
/// last.
std::uint64_t cube_key(const Eigen::Vector3f& point, float edge) {
  constexpr float half = 1048576.0F;
  const Eigen::Array3f cube = (point / edge).array().floor().max(-half).min(half - 1.0F) + half;
  return static_cast<std::uint64_t>(cube.x()) << 42U | static_cast<std::uint64_t>(cube.y()) << 21U |
         static_cast<std::uint64_t>(cube.z());
}

}  // namespace

std::vector<Eigen::Vector3f> one_per_cube(const std::vector<Eigen::Vector3f>& points, float edge) {
  struct Keyed {
    std::uint64_t cube;
    std::uint32_t index;
  };
  std::vector<Keyed> keyed(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    keyed[i] = {cube_key(points[i], edge), static_cast<std::uint32_t>(i)};
  std::sort(keyed.begin(), keyed.end(), [](const Keyed& a, const Keyed& b) {
    return a.cube != b.cube ? a.cube < b.cube : a.index < b.index;
  });
  std::vector<Eigen::Vector3f> some;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i == 0 || keyed[i].cube != keyed[i - 1].cube) some.push_back(points[keyed[i].index]);
  }
  return some;
}

std::vector<Eigen::Vector3f> surface_points(const GraspObject& object, float spacing) {
  const TriangleMesh& mesh = object.surface.mesh;
  std::vector<Eigen::Vector3f> points;
  const auto vertex = [&](Eigen::Index t, Eigen::Index k) {
    return Corner(mesh.vertices.row(mesh.triangles(t, k)).transpose());
  };
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    append_triangle(vertex(t, 0), vertex(t, 1), vertex(t, 2), spacing, points);
  if (points.empty()) {
    for (Index i = 0; i < object.observed.size(); ++i)
      points.push_back(object.observed.position(i));
  }
  return one_per_cube(points, 0.5F * spacing);
}

}  // namespace symscene
