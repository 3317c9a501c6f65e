#include "symscene/simulation/scanned_models.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.hpp"
#include "core/surface_sampling.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/ground_truth/truth_file.hpp"
#include "symscene/io/mesh.hpp"

namespace symscene {
namespace {

/// The mean distance of a surface from itself after rotations about an axis through its centre.
double mean_change(const PointCloud& surface, const CellList& cells, const RotationAxis& axis,
                   double reach) {
  constexpr std::array angles{30.0, 60.0, 90.0, 135.0, 180.0};
  double sum = 0.0, count = 0.0;
  for (const Index i : evenly_spread(surface.size(), 300)) {
    for (const double angle : angles) {
      const Eigen::Vector3f turned =
          axis.rotate_point(surface.position(i).cast<double>(), radians(angle)).cast<float>();
      const auto [nearest, squared_distance] = cells.nearest(turned, static_cast<float>(reach));
      count += 1.0;
      sum += nearest == CellList::none ? reach
                                       : std::abs(static_cast<double>(surface.normal(nearest).dot(
                                             turned - surface.position(nearest))));
    }
  }
  return sum / count;
}

}  // namespace

bool is_ball(const TriangleMesh& mesh) {
  constexpr double strict = 0.008;  // of the diagonal, the bound of strict symmetries
  constexpr double far = 0.05;      // of the diagonal
  constexpr int axes = 40;
  const PointCloud surface = sample_surface(mesh, 6000);
  const Eigen::Vector3d centre = centroid(surface.positions);
  const auto diagonal = static_cast<double>(bounding_box(surface.positions).extent().norm());
  const CellList cells(surface.positions, static_cast<float>(far * diagonal));
  Random random(1);
  for (int k = 0; k < axes; ++k) {
    const Eigen::Vector3d direction =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    if (mean_change(surface, cells, {centre, direction}, far * diagonal) > strict * diagonal)
      return false;
  }
  return true;
}

ModelFolder read_models(const std::filesystem::path& meshes,
                        const std::filesystem::path& symmetries) {
  std::vector<TrueObject> known;
  if (!symmetries.empty()) known = read_model_symmetries(symmetries);
  MeshFolder folder = read_mesh_folder(meshes);
  ModelFolder result{{}, std::move(folder.warnings)};
  for (NamedMesh& file : folder.meshes) {
    ObjectModel model{std::move(file.name), std::move(file.mesh), {}, {}, false};
    const auto own = std::find_if(known.begin(), known.end(), [&](const TrueObject& object) {
      return object.name == model.name;
    });
    if (own != known.end()) {
      model.rotational = own->rotational;
      model.reflectional = own->reflectional;
      model.sphere = own->sphere || is_ball(model.mesh);
    }
    result.models.push_back(std::move(model));
  }
  return result;
}

}  // namespace symscene
