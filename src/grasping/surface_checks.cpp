#include "surface_checks.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

/// Several million samples, 3 mm apart: a cube of 3 m. [m²]
constexpr double largest = 50.0;

/// The squared longest edges of all triangles: at least twice their area, and more for slender
/// ones, which take as many samples. [m²]
double squared_edges(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](int k) { return mesh.vertices.row(mesh.triangles(t, k)); };
    sum += std::max({(corner(0) - corner(1)).squaredNorm(), (corner(1) - corner(2)).squaredNorm(),
                     (corner(2) - corner(0)).squaredNorm()});
  }
  return sum;
}

}  // namespace

void require_moderate_size(const ObjectSurface& surface, std::size_t id) {
  if (squared_edges(surface.mesh) <= largest) return;
  const Eigen::Vector3f extent = bounding_box(surface.mesh.vertices).extent();
  throw InputError(
      fmt::format("surface of object {}", id),
      fmt::format("triangles of at most {:.0f} m2 (are the units metres?)", largest / 2.0),
      fmt::format("an extent of {:.4g} x {:.4g} x {:.4g} m", extent.x(), extent.y(), extent.z()));
}

}  // namespace symscene
