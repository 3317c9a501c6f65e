#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/spacing.hpp"
#include "facts.hpp"
#include "ground_truth.hpp"
#include "models.hpp"
#include "symscene/io/cloud.hpp"
#include "symscene/io/mesh.hpp"
#include "symscene/io/octomap.hpp"
#include "symscene/io/scene.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

Facts::Json position_json(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }

void add_box(Facts& facts, const Points& points) {
  const Box box = bounding_box(points);
  const Eigen::Vector3f size = box.extent();
  facts.add("box",
            fmt::format("{:.3f} {:.3f} {:.3f} to {:.3f} {:.3f} {:.3f}: {:.3f}×{:.3f}×{:.3f} m",
                        box.min.x(), box.min.y(), box.min.z(), box.max.x(), box.max.y(),
                        box.max.z(), size.x(), size.y(), size.z()),
            "box", {{"min", position_json(box.min)}, {"max", position_json(box.max)}});
}

void add_cloud(Facts& facts, const PointCloud& cloud) {
  const PointIndices finite = finite_points(cloud.positions);
  std::string text = fmt::format("{}, {} normals, {} colour", cloud.size(),
                                 cloud.has_normals() ? "with" : "without",
                                 cloud.has_colors() ? "with" : "without");
  if (finite.size() < cloud.size()) {
    text += fmt::format("; {} of them not finite", cloud.size() - finite.size());
  }
  facts.add("points", text, "points", cloud.size());
  facts.add_member("normals", cloud.has_normals());
  facts.add_member("color", cloud.has_colors());
  if (finite.size() < 2) return;
  const Points points = select(cloud, finite).positions;
  add_box(facts, points);
  const double spacing = median_spacing(points).value_or(0.0F);
  facts.add("spacing", fmt::format("{:.2f} mm to the nearest other point (median)", 1e3 * spacing),
            "spacing", spacing);
}

/// Total volume of the leaves in a state. [m³]
double volume(const OccupancyMap& map, VoxelState state) {
  double voxels = 0.0;
  for (const OccupancyLeaf& leaf : map.leaves) {
    if (leaf.state == state) voxels += std::ldexp(1.0, 3 * leaf.level);
  }
  return voxels * std::pow(map.resolution, 3);
}

void add_occupancy(Facts& facts, const OccupancyMap& map) {
  const double free = volume(map, VoxelState::free);
  const double occupied = volume(map, VoxelState::occupied);
  facts.add("occupancy",
            fmt::format("{} leaves, voxels of {:g} mm: {:.4f} m³ free, {:.4f} m³ occupied",
                        map.leaves.size(), 1e3 * map.resolution, free, occupied),
            "occupancy",
            {{"leaves", map.leaves.size()},
             {"resolution", map.resolution},
             {"free", free},
             {"occupied", occupied}});
}

void add_mesh(Facts& facts, const TriangleMesh& mesh) {
  facts.add("mesh",
            fmt::format("{} triangles, {} vertices, {} colour", mesh.triangles.rows(),
                        mesh.vertices.rows(), mesh.colors.rows() != 0 ? "with" : "without"),
            "mesh", {{"triangles", mesh.triangles.rows()}, {"vertices", mesh.vertices.rows()}});
}

void add_table(Facts& facts, const Plane& table) {
  const Eigen::Vector3d& n = table.normal;
  facts.add(
      "table",
      fmt::format("{:.4f} x {:+.4f} y {:+.4f} z {:+.4f} = 0", n.x(), n.y(), n.z(), table.offset),
      "table", {n.x(), n.y(), n.z(), table.offset});
}

}  // namespace

Facts scene_facts(const fs::path& dir) {
  const Scene scene = read_scene(dir);
  Facts facts("scene");
  facts.add_warnings(scene.warnings);
  facts.add_row("scene", folder_name(dir));
  add_cloud(facts, scene.cloud);
  if (scene.occupancy) add_occupancy(facts, *scene.occupancy);
  if (scene.table) add_table(facts, *scene.table);
  add_ground_truth(facts, dir, scene.cloud.size());
  if (fs::exists(dir / "mesh.ply")) add_mesh(facts, read_mesh(dir / "mesh.ply"));
  return facts;
}

bool is_model_file(const fs::path& path) {
  static constexpr std::array<const char*, 7> extensions = {".ply", ".pcd",  ".obj", ".stl",
                                                            ".glb", ".gltf", ".bt"};
  return fs::is_regular_file(path) &&
         std::find(extensions.begin(), extensions.end(), lower_extension(path)) != extensions.end();
}

Facts model_facts(const fs::path& path) {
  if (lower_extension(path) == ".bt") {
    Facts facts("occupancy");
    add_occupancy(facts, read_octomap(path));
    return facts;
  }
  if (is_cloud_file(path)) {
    Facts facts("cloud");
    add_cloud(facts, read_cloud(path));
    return facts;
  }
  Facts facts("mesh");
  const TriangleMesh mesh = read_mesh(path);
  add_mesh(facts, mesh);
  add_box(facts, mesh.vertices);
  return facts;
}

}  // namespace symscene::app
