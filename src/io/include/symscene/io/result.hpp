#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The text of objects.json (docs/formats.md, docs/objects.schema.json): the whole result except
/// its clouds. Equal results give equal bytes; without timings (`with_timings` false), runs on
/// equal input do. Times of stages with the same name are added. `made_by` is JSON that tells what
/// made the result; nothing by default. Throws InputError if a number of an object is not finite or
/// `made_by` is not JSON.
std::string format_objects_json(const SegmentationResult& result, bool with_timings = true,
                                const std::string& made_by = "");

/// Reads objects.json back, of this version and earlier ones; `cloud`, `completed` and `surfaces`
/// of the result are empty. Normals and directions are scaled to unit length. `name` is the name of
/// the file in messages. Throws InputError if the text is not a valid objects.json or an index is
/// not below `cloud_size`.
SegmentationResult parse_objects_json(std::string_view text, const std::string& name,
                                      Index cloud_size);

/// Optional parts of a result folder: what shows the surroundings of the objects, and what made it.
struct ResultExtras {
  const TriangleMesh* surface = nullptr;   ///< surface.ply
  const Trajectory* trajectory = nullptr;  ///< poses.txt
  std::string made_by = {};                ///< JSON: made_by of objects.json
};

/// Writes a result folder atomically: cloud.ply, objects.json, the extras, and for object N the
/// file objects/N.ply with its points (observed = 1) followed by those that completion added
/// (observed = 0), and objects/N.obj with its closed surface, if that is not empty. Throws
/// InputError if the result is inconsistent, if `dir` is neither empty nor a result folder, or if
/// it cannot be written; an existing folder is then unchanged.
void write_result(const std::filesystem::path& dir, const SegmentationResult& result,
                  const ResultExtras& extras = {});

/// Reads a result folder; `completed` and `surfaces` have one, possibly empty, per object.
/// Throws InputError if `dir` is not a result folder or its files contradict each other.
SegmentationResult read_result(const std::filesystem::path& dir);

/// The surroundings of the objects; empty if the folder has no file of them.
struct Surroundings {
  TriangleMesh surface;
  Trajectory trajectory;  ///< camera poses
};

/// Reads surface.ply and poses.txt of a result folder.
/// Throws InputError if one of them exists and is not valid.
Surroundings read_result_surroundings(const std::filesystem::path& dir);

}  // namespace symscene
