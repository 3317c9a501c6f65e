#include "segment_input.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cloud_units.hpp"
#include "core/naming.hpp"
#include "io/atomic_file.hpp"
#include "models.hpp"
#include "sequence_only.hpp"
#include "symscene/io/cloud.hpp"
#include "symscene/io/mesh.hpp"
#include "symscene/io/result.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/io/trajectory.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* an_input =
    "a scene folder, a depth image, a folder with one frame, or a cloud (.ply, .pcd)";

/// Whether the cloud is a bare table: a plane too large to be a face of an object, and little else.
bool is_all_table(const PointCloud& cloud, const TableScene& found,
                  const SupportPlaneOptions& options) {
  constexpr double nearly_all = 0.98;
  if (!found.objects.cloud.empty() || found.planes.supports[0].area < options.wall_area)
    return false;
  Index on_plane = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    const double height =
        found.planes.supports[0].plane.signed_distance(cloud.position(i).cast<double>());
    on_plane += std::abs(height) < options.inlier_distance ? 1 : 0;
  }
  return static_cast<double>(on_plane) > nearly_all * static_cast<double>(cloud.size());
}

/// Reads a file if it exists. An invalid file gives a warning and an empty value.
template <class Value, class Read>
Value read_if_there(const fs::path& file, Session& session, const Read& read) {
  if (!fs::exists(file)) return {};
  try {
    return read(file);
  } catch (const InputError& error) {
    session.warn(fmt::format("{}; it is left out", error.what()));
    return {};
  }
}

/// Whether the name is that of a cloud. The vertices of a mesh are one too.
bool has_points(const fs::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".ply" || extension == ".pcd";
}

/// Depth images alone do not tell their unit. Nearly all cameras write millimetres.
SequenceOptions in_millimetres(SequenceOptions options, const fs::path& path) {
  const bool is_image = fs::is_regular_file(path) && path.extension() == ".png";
  if (is_image && !options.depth_scale) options.depth_scale = 1000.0;
  return options;
}

/// Warns of a table that is larger than tables are.
void doubt_table(const ViewInput& view, const DepthUse& depths, Session& session) {
  const auto& supports = view.scene.built.table.planes.supports;
  if (supports.empty()) return;
  if (const auto doubt = large_table_warning(view.frame, supports.front().area, depths))
    session.warn(*doubt);
}

void scale_to_metres(SensorCloud& seen) {
  seen.cloud.positions *= 0.001F;
  seen.viewpoint *= 0.001;
}

}  // namespace

void SegmentSource::add_to(Arguments& arguments) {
  arguments.sequence_options(sequence);
  table.add_to(arguments, "the table plane a,b,c,d with ax + by + cz + d = 0");
  sensor.add_to(arguments);
  arguments.choice("--units", units, {"m", "mm"}, "unit of a cloud's coordinates (default m)");
}

void SegmentSource::require_no_camera(const char* kind) const {
  const char* given = given_camera_option(sequence);
  if (given == nullptr && sensor.is_named()) given = "--sensor";
  if (given != nullptr)
    throw InputError(path.string(), fmt::format("a depth image, as {} needs", given), kind);
}

void SegmentSource::require_no_units() const {
  if (!units.empty())
    throw InputError(path.string(), "a cloud (.ply, .pcd), as --units needs", "another input");
}

/// Whether the cloud of a scene folder may hold its table still: one that symscene wrote does not.
bool SegmentSource::may_hold_table() const {
  return !table.none && !fs::exists(path / "table_plane.txt") && !fs::exists(path / "scene.json") &&
         !fs::exists(path / "objects.json");
}

bool SegmentSource::is_cloud() const {
  return is_scene_folder(path) || (fs::is_regular_file(path) && has_points(path));
}

/// Takes the table, if one with objects on it is found or it is all there is, from the cloud of a
/// scene folder. The occupancy stays. Where no point is on the plane of --plane, the cloud is that
/// of the objects.
void SegmentSource::crop_table(Scene& scene, const SegmentOptions& options,
                               Session& session) const {
  const fs::path file = scene_cloud_file(path);
  BuiltScene built = naming(file, [&] {
    return even_if_plane_misses(table.known({}), [&](const TablePrior& known) {
      return cloud_scene(scene.cloud, read_sensor_cloud(file).viewpoint, known,
                         {options.cloud_normals, options.view.scene});
    });
  });
  if (!built.scene.table && !table.plane.empty()) return;
  const bool is_bare =
      built.scene.table && is_all_table(scene.cloud, built.table, options.view.scene.table.plane);
  if (!is_bare && (!built.scene.table || built.scene.cloud.empty())) {
    scene.warnings.push_back(
        fmt::format("{} is missing, and no table with objects on it is found in the cloud",
                    (path / "table_plane.txt").string()));
    return;
  }
  print_table(built, session);
  scene.cloud = std::move(built.scene.cloud);
  scene.table = built.scene.table;
  for (std::string& warning : built.scene.warnings) scene.warnings.push_back(std::move(warning));
}

SegmentInput SegmentSource::read_folder(const SegmentOptions& options, Session& session) const {
  SegmentInput input;
  const bool is_searched = may_hold_table();
  const fs::path result = path / "objects.json";
  const bool is_result = fs::exists(result);
  input.scene = read_scene(path, {.expects_table = !is_searched && !is_result && !table.is_told()});
  if (is_result)
    input.scene.table =
        parse_objects_json(read_file(result), result.string(), input.scene.cloud.size()).table;
  require_no_camera("a scene");
  if (table.any_up && input.scene.table)
    throw InputError("--any-up", "a table to search", "a scene with table_plane.txt");
  if (table.any_up && !table.none && !is_searched)
    throw InputError("--any-up", "a cloud that may hold its table",
                     "a scene of objects without a table");
  if (is_searched && !input.scene.cloud.empty()) crop_table(input.scene, options, session);
  if (const std::optional<Plane> plane = table.table()) input.scene.table = plane;
  if (table.none) input.scene.table.reset();
  // Those of the reader first: they explain why segmentation may fail. The result repeats them.
  session.warn(input.scene.warnings);
  input.surface = read_if_there<TriangleMesh>(path / (is_result ? "surface.ply" : "mesh.ply"),
                                              session, read_mesh);
  input.trajectory = read_if_there<Trajectory>(path / "poses.txt", session, read_trajectory);
  return input;
}

SegmentInput SegmentSource::read_cloud_file(const SegmentOptions& options, Session& session) const {
  require_no_camera("a cloud");
  StageTimer timer(session.on_begin());
  SensorCloud seen = timer.time("read", [&] { return read_sensor_cloud(path); });
  const bool is_scaled = units == "mm";
  if (is_scaled) scale_to_metres(seen);
  if (const auto doubt =
          check_cloud_units(seen.cloud.positions, is_scaled, path.string(), options.pipeline))
    session.warn(*doubt);
  BuiltScene built = timer.time("find table", [&] {
    return naming(path, [&] {
      return cloud_scene(seen.cloud, seen.viewpoint, table.known({}),
                         {options.cloud_normals, options.view.scene});
    });
  });
  report_table(built, session);
  return {std::move(built.scene), {}, {}, timer.stages(), {}, {}, {}};
}

SegmentInput SegmentSource::read_view(const SegmentOptions& options, Session& session) const {
  StageTimer timer(session.on_begin());
  const auto sequence = open_sequence(path, in_millimetres(this->sequence, path));
  session.warn(sequence->warnings());
  if (sequence->size() != 1) {
    throw InputError(path.string(),
                     "one frame (run symscene reconstruct first, which makes a scene of many)",
                     fmt::format("{} frames", sequence->size()));
  }
  DepthFrame frame = timer.time("read", [&] { return sequence->read(0); });
  const DepthUse depths{sequence->depth_scale(), options.view.points.min_depth,
                        options.view.points.max_depth};
  const ReportedSensor chosen = timer.time("estimate sensor", [&] {
    constexpr bool tracked = false;
    return sensor.choose({&frame, 1}, tracked, sequence->camera(), depths, options.sensor, session);
  });
  ViewInput view = naming(path, [&] {
    return view_input(std::move(frame), sequence->camera(), chosen, table.told(), options.view);
  });
  for (const StageTime& stage : view.scene.stages) timer.add(stage.stage, stage.seconds);
  report_table(view.scene.built, session);
  doubt_table(view, depths, session);
  return {std::move(view.scene.built.scene),
          std::move(view.surface),
          std::move(view.cameras),
          timer.stages(),
          std::move(view.frame),
          sequence->camera(),
          chosen};
}

SegmentInput SegmentSource::read(const SegmentOptions& options, Session& session) const {
  if (fs::is_regular_file(path) && has_points(path)) return read_cloud_file(options, session);
  if (fs::exists(path)) require_no_units();
  if (is_scene_folder(path)) return read_folder(options, session);
  if (is_sequence(path)) return read_view(options, session);
  if (!fs::exists(path)) throw InputError(path.string(), an_input, "nothing of that name");
  if (fs::is_regular_file(path)) throw InputError(path.string(), an_input, "another file");
  return read_folder(options, session);
}

}  // namespace symscene::app
