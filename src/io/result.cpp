#include "symscene/io/result.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "cloud_checks.hpp"
#include "io/atomic_file.hpp"
#include "io/ply.hpp"
#include "mesh_formats.hpp"
#include "objects_json.hpp"
#include "ply_points.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/mesh.hpp"
#include "symscene/io/trajectory.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

constexpr const char* folder_to_write = "result to write";

/// Whether `file` is NUMBER.ply or NUMBER.obj.
bool is_object_file(std::string_view file) {
  if (!(file.ends_with(".ply") || file.ends_with(".obj")) || file.size() == 4) return false;
  file.remove_suffix(4);
  return std::all_of(file.begin(), file.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool belongs_to_result(const std::string& relative) {
  static constexpr std::array<std::string_view, 5> files = {"cloud.ply", "objects.json", "objects/",
                                                            "surface.ply", "poses.txt"};
  if (std::find(files.begin(), files.end(), relative) != files.end()) return true;
  return relative.starts_with("objects/") && is_object_file(relative.substr(8));
}

void require_surface(const ObjectSurface& surface) {
  const TriangleMesh& mesh = surface.mesh;
  if (static_cast<Eigen::Index>(surface.observed.size()) != mesh.triangles.rows())
    throw InputError(folder_to_write, "a flag per triangle of a surface", "others");
  if (mesh.triangles.rows() == 0) return;
  const Index last = mesh.triangles.maxCoeff();
  if (static_cast<Eigen::Index>(last) >= mesh.vertices.rows()) {
    throw InputError(folder_to_write,
                     fmt::format("corners of a surface below {}, the number of its vertices",
                                 mesh.vertices.rows()),
                     std::to_string(last));
  }
}

void require_surfaces(const SegmentationResult& result) {
  const std::size_t count = result.surfaces.size();
  if (count != 0 && count != result.objects.size()) {
    throw InputError(folder_to_write,
                     fmt::format("{} surfaces, one per object", result.objects.size()),
                     std::to_string(count));
  }
  for (const ObjectSurface& surface : result.surfaces) require_surface(surface);
}

void require_writable(const SegmentationResult& result) {
  require_consistent(result.cloud, folder_to_write);
  if (!result.completed.empty() && result.completed.size() != result.objects.size()) {
    throw InputError(folder_to_write,
                     fmt::format("{} completed clouds, one per object", result.objects.size()),
                     std::to_string(result.completed.size()));
  }
  for (const PointCloud& completed : result.completed)
    require_consistent(completed, folder_to_write);
  require_surfaces(result);
  for (const SceneObject& object : result.objects) {
    const PointIndices& points = object.points;
    const bool ascending =
        std::adjacent_find(points.begin(), points.end(), std::greater_equal<>()) == points.end();
    if (!ascending || (!points.empty() && points.back() >= result.cloud.size())) {
      throw InputError(folder_to_write, "ascending indices of points of the cloud", "others");
    }
    for (const double share : {object.rank(), object.confidence}) {
      if (!(share >= 0.0 && share <= 1.0))
        throw InputError(folder_to_write, "scores in [0, 1]", fmt::format("{}", share));
    }
  }
}

/// The rows of `above`, then those of `below`; zeros where one of them has none.
template <class Rows>
Rows stacked(const Rows& above, Eigen::Index above_rows, const Rows& below,
             Eigen::Index below_rows) {
  if (above.rows() == 0 && below.rows() == 0) return {};
  Rows rows = Rows::Zero(above_rows + below_rows, 3);
  rows.topRows(above.rows()) = above;
  rows.bottomRows(below.rows()) = below;
  return rows;
}

std::string format_object_cloud(const PointCloud& own, const PointCloud& added) {
  const Eigen::Index own_rows = own.positions.rows();
  const Eigen::Index added_rows = added.positions.rows();
  const PointCloud both{stacked(own.positions, own_rows, added.positions, added_rows),
                        stacked(own.normals, own_rows, added.normals, added_rows),
                        stacked(own.colors, own_rows, added.colors, added_rows)};
  std::vector<std::uint8_t> observed(both.size(), 0);
  std::fill_n(observed.begin(), own_rows, std::uint8_t{1});
  return format_ply_marked(both, observed);
}

/// The points that completion added to an object, from its file.
PointCloud read_added(const fs::path& path, std::size_t own_size) {
  const MarkedCloud marked = parse_ply_marked(read_file(path), path.string());
  if (!marked.cloud.empty() && marked.observed.empty()) {
    throw InputError(path.string(), "points with a property observed", "none");
  }
  PointIndices indices;
  for (Index i = 0; i < marked.cloud.size(); ++i) {
    if (marked.observed[i] == 0) indices.push_back(i);
  }
  if (marked.cloud.size() - indices.size() != own_size) {
    throw InputError(path.string(), fmt::format("{} observed points", own_size),
                     std::to_string(marked.cloud.size() - indices.size()));
  }
  PointCloud added = select(marked.cloud, indices);
  if ((added.normals.array() == 0.0F).all()) added.normals.resize(0, 3);
  if ((added.colors.array() == 0).all()) added.colors.resize(0, 3);
  return added;
}

/// The closed surface of an object; empty if objects.json does not name it.
ObjectSurface read_surface(const fs::path& path, bool is_named) {
  if (is_named) return parse_obj_surface(read_file(path), path.string());
  if (fs::exists(path))
    throw InputError(path.string(), "no file, as objects.json does not name it", "one");
  return {};
}

}  // namespace

void write_result(const fs::path& dir, const SegmentationResult& result,
                  const ResultExtras& extras) {
  require_writable(result);
  static const PointCloud no_points;
  AtomicDirectory folder(dir, {"a result folder", "objects.json", belongs_to_result});
  folder.write("cloud.ply", format_ply(result.cloud));
  folder.write("objects.json", format_objects_json(result, true, extras.made_by));
  for (std::size_t id = 0; id < result.objects.size(); ++id) {
    const PointCloud own = select(result.cloud, result.objects[id].points);
    const PointCloud& added = result.completed.empty() ? no_points : result.completed[id];
    folder.write(object_cloud_name(id), format_object_cloud(own, added));
    if (has_surface(result, id)) folder.write(surface_name(id), format_obj(result.surfaces[id]));
  }
  if (extras.surface != nullptr) folder.write("surface.ply", format_ply(*extras.surface));
  if (extras.trajectory != nullptr)
    folder.write("poses.txt", format_trajectory(*extras.trajectory));
  folder.commit();
}

SegmentationResult read_result(const fs::path& dir) {
  if (!fs::is_directory(dir) || !fs::exists(dir / "objects.json")) {
    throw InputError(dir.string(), "a result folder, which holds cloud.ply and objects.json",
                     fs::exists(dir) ? "no objects.json" : "nothing of that name");
  }
  PointCloud cloud = parse_ply_cloud(read_file(dir / "cloud.ply"), (dir / "cloud.ply").string());
  const fs::path objects = dir / "objects.json";
  ParsedObjects parsed = parse_objects(read_file(objects), objects.string(), cloud.size());
  SegmentationResult& result = parsed.result;
  result.cloud = std::move(cloud);
  for (std::size_t id = 0; id < result.objects.size(); ++id) {
    result.completed.push_back(
        read_added(dir / object_cloud_name(id), result.objects[id].points.size()));
    result.surfaces.push_back(read_surface(dir / surface_name(id), parsed.names_surface[id] != 0));
  }
  return std::move(parsed.result);
}

Surroundings read_result_surroundings(const fs::path& dir) {
  Surroundings found;
  if (fs::exists(dir / "surface.ply")) found.surface = read_mesh(dir / "surface.ply");
  if (fs::exists(dir / "poses.txt")) found.trajectory = read_trajectory(dir / "poses.txt");
  return found;
}

}  // namespace symscene
