#include "annotated_symmetries.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene::bench {
namespace {

constexpr std::array numbers{"002", "003", "004", "005", "006", "007", "008",
                             "009", "010", "011", "019", "021", "024", "025",
                             "035", "036", "037", "040", "051", "052", "061"};
constexpr std::string_view wrong = "011";
constexpr std::size_t lines_per_model = 5;

std::vector<Eigen::Vector3d> read_vectors(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<Eigen::Vector3d> vectors;
  Eigen::Vector3d v;
  while (file >> v.x() >> v.y() >> v.z()) vectors.push_back(v);
  if (vectors.size() != lines_per_model * numbers.size())
    throw InputError(path.string(),
                     fmt::format("{} lines of three numbers", lines_per_model * numbers.size()),
                     fmt::format("{}", vectors.size()));
  return vectors;
}

/// What is found and is nearest in direction to an annotated symmetry.
struct Nearest {
  double angle = std::numeric_limits<double>::infinity();
  double distance = 0.0;  ///< from the centroid
  double residual = 0.0;

  void take(double other_angle, double other_distance, double other_residual) {
    if (other_angle < angle) *this = {other_angle, other_distance, other_residual};
  }
};

Nearest nearest_plane(const Eigen::Vector3d& normal, const MovedMesh& mesh,
                      const SymmetryGroup& group) {
  Nearest nearest;
  for (const GroupPlane& found : group.planes)
    nearest.take(line_angle(normal, found.plane.normal),
                 std::abs(found.plane.signed_distance(mesh.centroid())),
                 mesh.residual(found.plane));
  for (const GroupAxis& found : group.axes) {  // planes through a continuous axis are symmetries
    if (found.order != GroupAxis::continuous) continue;
    const SymmetryDifference apart =
        difference(ReflectionPlane{mesh.centroid(), normal}, found.axis, mesh.centroid());
    const Eigen::Vector3d& axis = found.axis.direction;
    const ReflectionPlane through{found.axis.point,
                                  (normal - normal.dot(axis) * axis).normalized()};
    nearest.take(apart.angle, apart.distance, mesh.residual(through));
  }
  return nearest;
}

Nearest nearest_axis(const Eigen::Vector3d& direction, const MovedMesh& mesh,
                     const SymmetryGroup& group) {
  Nearest nearest;
  for (const GroupAxis& found : group.axes)
    nearest.take(line_angle(direction, found.axis.direction), found.axis.distance(mesh.centroid()),
                 mesh.residual(found.axis, found.order));
  return nearest;
}

/// The residual of a plane with this normal at the best distance from the centroid.
double best_residual(const Eigen::Vector3d& normal, const MovedMesh& mesh, double diagonal) {
  constexpr int steps = 12;              // to each side
  constexpr double step = 0.03 / steps;  // by the diagonal
  double best = std::numeric_limits<double>::infinity();
  for (int k = -steps; k <= steps; ++k)
    best = std::min(best, mesh.residual(ReflectionPlane{
                              mesh.centroid() + k * step * diagonal * normal, normal}));
  return best;
}

std::string compare(const std::string& what, const Nearest& nearest, double annotated,
                    double diagonal, AnnotationCounts& counts) {
  const bool is_near = nearest.angle < radians(1.0);
  ++counts.all;
  counts.near_angle += is_near ? 1 : 0;
  counts.near += is_near && nearest.distance < 0.01 * diagonal ? 1 : 0;
  counts.annotation_better += annotated < nearest.residual ? 1 : 0;
  return fmt::format("{:32} {:5.2f}° {:5.2f} %   residual {:.2f} %, annotated {:.2f} %\n", what,
                     nearest.angle / radians(1.0), 100.0 * nearest.distance / diagonal,
                     100.0 * nearest.residual / diagonal, 100.0 * annotated / diagonal);
}

}  // namespace

std::vector<AnnotatedModel> read_annotated_models(const std::filesystem::path& path) {
  const std::vector<Eigen::Vector3d> vectors = read_vectors(path);
  std::vector<AnnotatedModel> models;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k] == wrong) continue;
    AnnotatedModel& model = models.emplace_back(AnnotatedModel{numbers[k], {}, {}});
    for (std::size_t line = 1; line < lines_per_model; ++line) {
      const Eigen::Vector3d& v = vectors[lines_per_model * k + line];
      if (v.isZero()) continue;
      (line + 1 == lines_per_model ? model.directions : model.normals).push_back(v.normalized());
    }
  }
  return models;
}

std::string compare_with_annotation(const AnnotatedModel& annotated, const std::string& name,
                                    const MovedMesh& mesh, const SymmetryGroup& group,
                                    AnnotationCounts& counts) {
  std::string text;
  for (const Eigen::Vector3d& normal : annotated.normals)
    text += compare(name + " plane", nearest_plane(normal, mesh, group),
                    best_residual(normal, mesh, group.diagonal), group.diagonal, counts);
  for (const Eigen::Vector3d& direction : annotated.directions) {
    const Nearest nearest = nearest_axis(direction, mesh, group);
    text += compare(name + " axis", nearest,
                    mesh.residual(RotationAxis{mesh.centroid(), direction}, GroupAxis::continuous),
                    group.diagonal, counts);
  }
  return text;
}

}  // namespace symscene::bench
