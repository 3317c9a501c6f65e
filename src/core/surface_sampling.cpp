#include "core/surface_sampling.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

struct Triangle {
  Eigen::Vector3d origin, u, v;  ///< a corner and the edges from it

  Eigen::Vector3d area_vector() const { return 0.5 * u.cross(v); }
};

Triangle triangle(const TriangleMesh& mesh, Eigen::Index t) {
  const auto corner = [&](int k) -> Eigen::Vector3d {
    return mesh.vertices.row(mesh.triangles(t, k)).transpose().cast<double>();
  };
  return {corner(0), corner(1) - corner(0), corner(2) - corner(0)};
}

/// The k-th point of the R2 sequence (Roberts 2018), folded into the unit triangle.
Eigen::Vector2d low_discrepancy(std::size_t k) {
  constexpr double plastic = 1.32471795724474602596;
  const double n = static_cast<double>(k) + 1.0;
  Eigen::Vector2d p(0.5 + n / plastic, 0.5 + n / (plastic * plastic));
  p -= Eigen::Vector2d(std::floor(p.x()), std::floor(p.y()));
  return p.sum() > 1.0 ? Eigen::Vector2d(1.0 - p.x(), 1.0 - p.y()) : p;
}

Eigen::Index nearest_corner(const Eigen::Vector2d& p) {
  const Eigen::Vector3d barycentric(1.0 - p.sum(), p.x(), p.y());
  Eigen::Index corner = 0;
  barycentric.maxCoeff(&corner);
  return corner;
}

}  // namespace

double surface_area(const TriangleMesh& mesh) {
  double area = 0.0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    area += triangle(mesh, t).area_vector().norm();
  return area;
}

PointCloud sample_surface(const TriangleMesh& mesh, std::size_t count) {
  const double area = surface_area(mesh);
  if (!(area > 0.0) || !std::isfinite(area)) {
    throw InputError("mesh", "triangles of positive area",
                     std::to_string(mesh.triangles.rows()) + " triangles without any");
  }
  const double area_per_point = area / static_cast<double>(count);
  PointCloud cloud;
  cloud.positions.resize(static_cast<Eigen::Index>(count) + 1, 3);
  cloud.normals.resize(cloud.positions.rows(), 3);
  if (mesh.colors.rows() != 0) cloud.colors.resize(cloud.positions.rows(), 3);

  Eigen::Index next = 0;
  double owed = 0.5 * area_per_point;  // area that no point represents yet
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Triangle shape = triangle(mesh, t);
    owed += shape.area_vector().norm();
    for (; owed >= area_per_point && next < cloud.positions.rows();
         owed -= area_per_point, ++next) {
      const Eigen::Vector2d p = low_discrepancy(static_cast<std::size_t>(next));
      cloud.positions.row(next) =
          (shape.origin + p.x() * shape.u + p.y() * shape.v).cast<float>().transpose();
      cloud.normals.row(next) = shape.area_vector().normalized().cast<float>().transpose();
      if (cloud.has_colors())
        cloud.colors.row(next) = mesh.colors.row(mesh.triangles(t, nearest_corner(p)));
    }
  }
  cloud.positions.conservativeResize(next, 3);
  cloud.normals.conservativeResize(next, 3);
  if (cloud.has_colors()) cloud.colors.conservativeResize(next, 3);
  return cloud;
}

PointCloud sample_surface_at(const TriangleMesh& mesh, double spacing) {
  const double area = surface_area(mesh);
  if (!(area > 0.0)) return {};
  return sample_surface(mesh, static_cast<std::size_t>(std::ceil(area / (spacing * spacing))));
}

}  // namespace symscene
