#include "object_input.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/naming.hpp"
#include "segmentation/occupancy_warning.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene::app {
bool is_result(const std::filesystem::path& path) {
  return std::filesystem::exists(path / "objects.json");
}

void ObjectInput::add_to(Arguments& arguments, const char* scene_help) {
  arguments.folder("--scene", scene, scene_help);
  source.add_to(arguments);
}

SegmentedInput ObjectInput::read(StageTimer& timer, Session& session) const {
  return is_result(source.path) ? of_result(timer, session) : of_scene(timer, session);
}

GraspScene ObjectInput::grasp_scene(const SegmentedInput& read, const GraspOptions& options) const {
  return naming(source.path, [&] {
    return symscene::grasp_scene(read.result, read.scene ? &*read.scene : nullptr, options);
  });
}

void ObjectInput::warn_without_occupancy(const std::filesystem::path& path,
                                         Session& session) const {
  session.warn(
      fmt::format("{}: no occupancy, so that space which was never seen counts as free for {}",
                  path.string(), use.user));
}

/// Segmentation and the command take space that was never seen in different ways.
void ObjectInput::warn_of_segmentation(std::span<const std::string> warnings,
                                       Session& session) const {
  for (const std::string& warning : warnings) {
    if (warning != no_occupancy_warning) {
      session.warn(warning);
      continue;
    }
    session.warn(fmt::format(
        "{}: no occupancy: all space off the surface counts as never seen where objects "
        "are found, and as free for {}",
        source.path.string(), use.user));
  }
}

/// Those of earlier versions have none.
void ObjectInput::warn_without_surfaces(const SegmentationResult& result, Session& session) const {
  const bool has_one =
      std::any_of(result.surfaces.begin(), result.surfaces.end(),
                  [](const ObjectSurface& s) { return s.mesh.triangles.rows() > 0; });
  if (result.objects.empty() || has_one) return;
  session.warn(fmt::format(
      "{}: its objects have no closed surfaces, which {} need; symscene segment writes them",
      source.path.string(), use.purpose));
}

/// The objects of a result, with the free space of its scene if that is given.
SegmentedInput ObjectInput::of_result(StageTimer& timer, Session& session) const {
  // A result tells its table itself.
  if (const char* given = source.table.given())
    throw InputError(given, "a scene, cloud or depth image as input", "a result");
  source.require_no_camera("a result");
  source.require_no_units();
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
      return input;
    }
    input.scene = read_scene(scene);
    session.warn(input.scene->warnings);
    if (!input.scene->occupancy) warn_without_occupancy(scene, session);
    return input;
  });
}

/// The objects that segmentation with default options finds.
SegmentedInput ObjectInput::of_scene(StageTimer& timer, Session& session) const {
  if (!scene.empty()) throw InputError("--scene", "a result folder as input", "a scene");
  SegmentInput read = timer.time("read", [&] { return source.read(SegmentOptions{}, session); });
  SegmentedInput input;
  input.result = timer.time("segment", [&] {
    if (read.scene.cloud.empty()) return nothing_found(read.scene);
    return naming(source.path, [&] { return segment_scene(read.scene); });
  });
  warn_of_segmentation(std::span(input.result.warnings).subspan(read.scene.warnings.size()),
                       session);
  if (with_page) {
    input.around = {surface_around(read.surface, input.result, source.path, session),
                    std::move(read.trajectory)};
  }
  if (read.frame) input.camera = read.camera;
  input.scene = std::move(read.scene);
  return input;
}

}  // namespace symscene::app
