#include "simulation/tabletop_meshes.hpp"

#include <algorithm>

#include "simulation/shapes.hpp"

namespace symscene {
namespace {

constexpr double room_size = 8.0;       // [m]
constexpr double room_thickness = 0.1;  // of floor and wall [m]

/// A box with its base at `base`, in the table's frame.
TriangleMesh box_at(const Tabletop& tabletop, const Eigen::Vector3d& base,
                    const Eigen::Vector3d& size, std::uint8_t brightness) {
  Eigen::Isometry3d T_world_box = tabletop.T_world_table;
  T_world_box.translate(base);
  TriangleMesh mesh = transformed(make_box(size, size.maxCoeff()), T_world_box);
  mesh.colors = Colors::Constant(mesh.vertices.rows(), 3, brightness);
  return mesh;
}

}  // namespace

std::vector<TriangleMesh> tabletop_meshes(const Tabletop& tabletop) {
  std::vector<TriangleMesh> meshes;
  for (const PlacedObject& placed : tabletop.objects) meshes.push_back(world_mesh(placed));
  const TableOptions& table = tabletop.table;
  meshes.push_back(box_at(tabletop, {0, 0, -table_thickness},
                          {table.length, table.width, table_thickness}, 170));
  const double floor = std::max(table.height, table_thickness);
  if (table.height > 0.0)
    meshes.push_back(box_at(tabletop, {0, 0, -floor - room_thickness},
                            {room_size, room_size, room_thickness}, 110));
  // The cameras of an arc stand on the side of positive x.
  if (table.wall_distance > 0.0)
    meshes.push_back(box_at(tabletop, {-table.wall_distance - 0.5 * room_thickness, 0, -floor},
                            {room_thickness, room_size, 3.0}, 200));
  return meshes;
}

}  // namespace symscene
