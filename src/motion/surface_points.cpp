#include "surface_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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

}  // namespace

std::vector<Eigen::Vector3f> one_per_cube(const std::vector<Eigen::Vector3f>& points, float edge) {
  using Keyed = std::pair<std::array<int, 3>, std::size_t>;
  std::vector<Keyed> keyed(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Array3i cube = (points[i] / edge).array().floor().cast<int>();
    keyed[i] = {{cube.x(), cube.y(), cube.z()}, i};
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<Eigen::Vector3f> some;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i == 0 || keyed[i].first != keyed[i - 1].first) some.push_back(points[keyed[i].second]);
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
