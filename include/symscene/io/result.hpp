#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/scene.hpp"

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

/// Writes a result folder atomically: cloud.ply, objects.json and for object N objects/N.ply, its
/// points (observed = 1) followed by those that completion added (observed = 0).
/// Throws InputError if the result contradicts itself, if `dir` is not empty and not a result
/// folder, or if it cannot be written; what was there is then as it was.
void write_result(const std::filesystem::path& dir, const SegmentationResult& result);

/// Reads a result folder back; `completed` has one cloud, maybe empty, an object.
/// Throws InputError if `dir` is no result folder or its files contradict each other.
SegmentationResult read_result(const std::filesystem::path& dir);

}  // namespace symscene
