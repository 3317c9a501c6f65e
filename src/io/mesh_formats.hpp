#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Wavefront OBJ: `v` with colours if there, and `f`; all else is skipped. Throws InputError.
TriangleMesh parse_obj(std::string_view bytes, const std::string& name);

/// STL, text or binary. Throws InputError.
TriangleMesh parse_stl(std::string_view bytes, const std::string& name);

/// The bytes of a file that a glTF file refers to by a path relative to itself.
using ReadBeside = std::function<std::string(const std::string& relative)>;

/// glTF 2.0, text or binary (GLB): the triangles of the scene, at the places that its nodes give
/// them. Throws InputError.
TriangleMesh parse_gltf(std::string_view bytes, const std::string& name,
                        const ReadBeside& read_beside);

}  // namespace symscene
