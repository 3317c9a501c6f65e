#include "symscene/clutter/graspability.hpp"

#include <cmath>

#include "core/surface_sampling.hpp"

namespace symscene {
namespace {

constexpr std::size_t line_starts = 300;

/// A point at which a line leaves a solid.
struct LineExit {
  double distance = 0.0;  ///< from the start of the line [m]
  double cosine = 0.0;    ///< of the outward normal with the line
};

Eigen::Vector3d corner(const TriangleMesh& mesh, Eigen::Index triangle, int k) {
  return mesh.vertices.row(mesh.triangles(triangle, k)).transpose().cast<double>();
}

/// Calls use(LineExit) for every triangle at whose back the line leaves the mesh (Möller and
/// Trumbore 1997).
template <class Use>
void for_each_exit(const TriangleMesh& mesh, const Eigen::Vector3d& start,
                   const Eigen::Vector3d& direction, const Use& use) {
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::Vector3d a = corner(mesh, t, 0), ab = corner(mesh, t, 1) - a,
                          ac = corner(mesh, t, 2) - a;
    const Eigen::Vector3d normal = ab.cross(ac);
    const double along = normal.dot(direction);
    if (along <= 0.0) continue;
    const Eigen::Vector3d moment = (start - a).cross(direction);
    const double u = -ac.dot(moment) / along, v = ab.dot(moment) / along;
    if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
    use(LineExit{normal.dot(a - start) / along, along / normal.norm()});
  }
}

/// Whether a fingertip has room between the table and its contact, from which it extends outwards.
bool tip_has_room(const Plane& table, const Eigen::Vector3d& contact,
                  const Eigen::Vector3d& outward, double thickness) {
  return table.signed_distance(contact + thickness * outward) >= 0.0;
}

}  // namespace

Graspability graspability(const TriangleMesh& mesh, const Plane& table, const Gripper& gripper,
                          double min_width) {
  const PointCloud starts = sample_surface(mesh, line_starts);
  const double least_cosine = std::cos(std::atan(gripper.friction));
  Graspability result;
  for (Index i = 0; i < starts.size() && !result.as_it_lies; ++i) {
    const Eigen::Vector3d start = starts.position(i).cast<double>();
    const Eigen::Vector3d inward = -starts.normal(i).cast<double>();
    for_each_exit(mesh, start, inward, [&](const LineExit& exit) {
      if (exit.distance < min_width || exit.distance > gripper.max_opening) return;
      if (exit.cosine < least_cosine) return;
      result.at_all = true;
      const Eigen::Vector3d end = start + exit.distance * inward;
      if (tip_has_room(table, start, -inward, gripper.tip_thickness) &&
          tip_has_room(table, end, inward, gripper.tip_thickness))
        result.as_it_lies = true;
    });
  }
  return result;
}

}  // namespace symscene
