#include "tabletop_meshes.hpp"

#include "shapes.hpp"

namespace symscene {
namespace {

constexpr double table_size = 2.4;  // [m]

TriangleMesh table_mesh(const Tabletop& tabletop) {
  Eigen::Isometry3d below = tabletop.T_world_table;
  below.translate(Eigen::Vector3d(0, 0, -table_thickness));
  TriangleMesh mesh =
      transformed(make_box({table_size, table_size, table_thickness}, table_size), below);
  mesh.colors = Colors::Constant(mesh.vertices.rows(), 3, 170);
  return mesh;
}

}  // namespace

std::vector<TriangleMesh> tabletop_meshes(const Tabletop& tabletop) {
  std::vector<TriangleMesh> meshes;
  for (const PlacedObject& placed : tabletop.objects) meshes.push_back(world_mesh(placed));
  meshes.push_back(table_mesh(tabletop));
  return meshes;
}

}  // namespace symscene
