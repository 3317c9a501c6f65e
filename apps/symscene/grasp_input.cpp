#include "grasp_input.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "segmentation/occupancy_warning.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene::app {
namespace {

void warn_without_occupancy(const std::filesystem::path& path, Session& session) {
  session.warn(
      fmt::format("{}: no occupancy, so that space which was never seen counts as free for the "
                  "gripper",
                  path.string()));
}

/// Segmentation and the gripper take space that was never seen in different ways.
void warn_of_segmentation(std::span<const std::string> warnings, const std::filesystem::path& path,
                          Session& session) {
  for (const std::string& warning : warnings) {
    if (warning != no_occupancy_warning) {
      session.warn(warning);
      continue;
    }
    session.warn(fmt::format(
        "{}: no occupancy: all space off the surface counts as never seen where objects "
        "are found, and as free for the gripper",
        path.string()));
  }
}

}  // namespace

bool is_result(const std::filesystem::path& path) {
  return std::filesystem::exists(path / "objects.json");
}

void GraspInput::add_to(Arguments& arguments, const char* scene_help) {
  arguments.folder("--scene", scene, scene_help);
  arguments.sequence_options(source.sequence);
  source.table.add_to(arguments, "the table plane a,b,c,d with ax + by + cz + d = 0");
  source.sensor.add_to(arguments);
}

void GraspInput::require_not_input(const std::filesystem::path& output) const {
  app::require_not_input(output, source.path);
  if (!scene.empty()) app::require_not_input(output, scene);
}

SegmentedInput GraspInput::read(StageTimer& timer, Session& session,
                                const GraspOptions& options) const {
  return is_result(source.path) ? of_result(timer, session, options)
                                : of_scene(timer, session, options);
}

GraspScene GraspInput::graspable(const SegmentationResult& result, const Scene* around,
                                 const GraspOptions& options) const {
  return naming(source.path, [&] { return grasp_scene(result, around, options); });
}

/// Those of earlier versions have none.
void GraspInput::warn_without_surfaces(const SegmentationResult& result, Session& session) const {
  const bool has_one =
      std::any_of(result.surfaces.begin(), result.surfaces.end(),
                  [](const ObjectSurface& s) { return s.mesh.triangles.rows() > 0; });
  if (result.objects.empty() || has_one) return;
  session.warn(fmt::format(
      "{}: its objects have no closed surfaces, which grasps need; symscene segment writes them",
      source.path.string()));
}

/// The objects of a result, with the free space of its scene if that is given.
SegmentedInput GraspInput::of_result(StageTimer& timer, Session& session,
                                     const GraspOptions& options) const {
  // A result tells its table itself.
  if (const char* given = source.table.given())
    throw InputError(given, "a scene, cloud or depth image as input", "a result");
  source.require_no_camera("a result");
  return timer.time("read", [&] {
    SegmentedInput input;
    input.result = read_result(source.path);
    if (with_page) input.around = read_result_surroundings(source.path);
    warn_without_surfaces(input.result, session);
    if (scene.empty()) {
      session.warn(
          fmt::format("{}: a result holds no occupancy, so that space which was never "
                      "seen counts as free; --scene names its scene",
                      source.path.string()));
      input.scene = graspable(input.result, nullptr, options);
    } else {
      const Scene around = read_scene(scene);
      session.warn(around.warnings);
      if (!around.occupancy) warn_without_occupancy(scene, session);
      input.scene = graspable(input.result, &around, options);
    }
    return input;
  });
}

/// The objects that segmentation with default options finds.
SegmentedInput GraspInput::of_scene(StageTimer& timer, Session& session,
                                    const GraspOptions& options) const {
  if (!scene.empty()) throw InputError("--scene", "a result folder as input", "a scene");
  SegmentInput read = timer.time("read", [&] { return source.read(SegmentOptions{}, session); });
  SegmentedInput input;
  input.result = timer.time("segment", [&] {
    if (read.scene.cloud.empty()) return nothing_found(read.scene);
    return naming(source.path, [&] { return segment_scene(read.scene); });
  });
  warn_of_segmentation(std::span(input.result.warnings).subspan(read.scene.warnings.size()),
                       source.path, session);
  input.scene = graspable(input.result, &read.scene, options);
  if (with_page) {
    input.around = {surface_around(read.surface, input.result, source.path, session),
                    std::move(read.trajectory)};
  }
  return input;
}

}  // namespace symscene::app
