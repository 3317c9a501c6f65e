#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "symscene/core/scene.hpp"

namespace symscene {

/// Names of an object's files in the folder of a result.
std::string object_cloud_name(std::size_t id);
std::string surface_name(std::size_t id);

/// Whether an object has a closed surface that is not empty; others have no file of it.
bool has_surface(const SegmentationResult& result, std::size_t id);

/// objects.json as it was read: parse_objects_json() and, per object, whether it names a surface.
struct ParsedObjects {
  SegmentationResult result;
  std::vector<std::uint8_t> names_surface;
};

ParsedObjects parse_objects(std::string_view text, const std::string& name, Index cloud_size);

}  // namespace symscene
