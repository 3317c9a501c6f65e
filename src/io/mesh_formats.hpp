#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "symscene/core/scene.hpp"

namespace symscene {

/// Parses Wavefront OBJ: `v`, with colours if present, and `f`; other lines are skipped. Throws
/// InputError.
TriangleMesh parse_obj(std::string_view bytes, const std::string& name);

/// The closed surface of an object: its triangles in the groups `observed` and `inferred`. The
/// decimals are exact.
std::string format_obj(const ObjectSurface& surface);

/// Parses what format_obj() writes; triangles outside the group `inferred` are observed. With
/// normals of the vertices. Throws InputError as parse_obj() does, or if a triangle has no area.
ObjectSurface parse_obj_surface(std::string_view bytes, const std::string& name);

/// Parses STL, text or binary. Throws InputError.
TriangleMesh parse_stl(std::string_view bytes, const std::string& name);

/// Returns the bytes of a file that a glTF file refers to by a path relative to itself.
using ReadBeside = std::function<std::string(const std::string& relative)>;

/// Parses glTF 2.0, text or binary (GLB): the triangles of the scene, transformed by its nodes.
/// Throws InputError.
TriangleMesh parse_gltf(std::string_view bytes, const std::string& name,
                        const ReadBeside& read_beside);

}  // namespace symscene
