#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// A mesh from a PLY, OBJ, STL, GLB or glTF 2.0 file, told apart by the extension: all its parts
/// where their transforms put them, as one mesh; except in PLY, vertices at the same place are one.
/// Units are the file's. Throws InputError if the extension is another, or the file is not what it
/// says or has no triangle.
TriangleMesh read_mesh(const std::filesystem::path& path);

/// The same from bytes; files that they refer to are not looked for. `extension` is "ply", "obj",
/// "stl", "glb" or "gltf"; `name` stands for the file in messages.
TriangleMesh parse_mesh(std::string_view bytes, const std::string& extension,
                        const std::string& name);

}  // namespace symscene
