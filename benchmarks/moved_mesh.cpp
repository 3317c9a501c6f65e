#include "moved_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/parallel.hpp"
#include "core/surface_sampling.hpp"
#include "io/thinned_surfaces.hpp"

namespace symscene::bench {
namespace {

constexpr std::size_t samples = 20000;  ///< for the centroid
constexpr Index moved = 700;            ///< of them are moved

std::vector<double> angles_of(int order) {
  if (order == 0) return {0.4, 1.3, 2.2, 3.1};
  std::vector<double> angles;
  for (int k = 1; 2 * k <= order; ++k) angles.push_back(2.0 * std::numbers::pi * k / order);
  return angles;
}

}  // namespace

MovedMesh::MovedMesh(const TriangleMesh& mesh) {
  const Eigen::Matrix<double, Eigen::Dynamic, 3> corners = mesh.vertices.cast<double>();
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](int k) {
      return Eigen::Vector3d(corners.row(static_cast<Eigen::Index>(mesh.triangles(t, k))));
    };
    Triangle triangle{corner(0), corner(1), corner(2), Eigen::Vector3d::Zero(), 0.0};
    triangle.middle = (triangle.a + triangle.b + triangle.c) / 3.0;
    for (const Eigen::Vector3d& each : {triangle.a, triangle.b, triangle.c})
      triangle.radius = std::max(triangle.radius, (each - triangle.middle).norm());
    triangles_.push_back(triangle);
  }
  const PointCloud surface = sample_surface(mesh, samples);
  centroid_ = surface.positions.cast<double>().colwise().mean().transpose();
  for (Index k = 0; k < moved; ++k)
    samples_.emplace_back(
        surface.position(static_cast<Index>(std::size_t{k} * surface.size() / moved))
            .cast<double>());
}

double MovedMesh::distance(const Eigen::Vector3d& point) const {
  double bound = std::numeric_limits<double>::infinity();
  for (const Triangle& each : triangles_)
    bound = std::min(bound, (point - each.middle).norm() + each.radius);
  for (const Triangle& each : triangles_) {
    if ((point - each.middle).norm() - each.radius < bound)
      bound = std::min(bound, distance_to_triangle(point, each.a, each.b, each.c));
  }
  return bound;
}

double MovedMesh::residual(const Eigen::Affine3d& motion) const {
  std::vector<double> distances(samples_.size());
  parallel_for_each(distances.size(),
                    [&](std::size_t k) { distances[k] = distance(motion * samples_[k]); });
  double sum = 0.0;
  for (const double each : distances) sum += each;
  return sum / static_cast<double>(distances.size());
}

double MovedMesh::residual(const ReflectionPlane& plane) const {
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.linear() -= 2.0 * plane.normal * plane.normal.transpose();
  motion.translation() = 2.0 * plane.normal.dot(plane.point) * plane.normal;
  return residual(motion);
}

double MovedMesh::residual(const RotationAxis& axis, int order) const {
  double worst = 0.0;
  for (const double angle : angles_of(order)) {
    Eigen::Affine3d motion = Eigen::Affine3d::Identity();
    motion.linear() = axis.rotation(angle);
    motion.translation() = axis.point - motion.linear() * axis.point;
    worst = std::max(worst, residual(motion));
  }
  return worst;
}

}  // namespace symscene::bench
