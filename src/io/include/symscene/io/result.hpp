#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The text of objects.json (docs/formats.md, docs/objects.schema.json): everything of the result
/// but its clouds. Equal results give equal bytes, `with_timings` false leaves out what varies from
/// run to run. Times of stages with one name are added.
/// Throws InputError if a number of an object is not finite.
std::string format_objects_json(const SegmentationResult& result, bool with_timings = true);

/// Reads objects.json back; `cloud` and `completed` of the result are empty. Normals and directions
/// are scaled to unit length. `name` stands for the file in messages.
/// Throws InputError if the text is no such file or an index is not below `cloud_size`.
SegmentationResult parse_objects_json(std::string_view text, const std::string& name,
                                      Index cloud_size);

/// What stands in a result folder beside the result, as far as it is there: what a view of it shows
/// around the objects.
struct ResultExtras {
  const TriangleMesh* surface = nullptr;   ///< surface.ply
  const Trajectory* trajectory = nullptr;  ///< poses.txt
};

/// Writes a result folder atomically: cloud.ply, objects.json, for object N objects/N.ply, its
/// points (observed = 1) followed by those that completion added (observed = 0), and the extras.
/// Throws InputError if the result contradicts itself, if `dir` is not empty and not a result
/// folder, or if it cannot be written; what was there is then as it was.
void write_result(const std::filesystem::path& dir, const SegmentationResult& result,
                  const ResultExtras& extras = {});

/// Reads a result folder back; `completed` has one cloud, maybe empty, an object.
/// Throws InputError if `dir` is no result folder or its files contradict each other.
SegmentationResult read_result(const std::filesystem::path& dir);

/// What surrounds the objects, as a view shows it; empty where a folder does not have it.
struct Surroundings {
  TriangleMesh surface;
  Trajectory trajectory;  ///< of the camera
};

/// surface.ply and poses.txt of a result folder.
/// Throws InputError if one is there and not what it should be.
Surroundings read_result_surroundings(const std::filesystem::path& dir);

}  // namespace symscene
