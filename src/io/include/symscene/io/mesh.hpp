#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// A mesh from a PLY, OBJ, STL, GLB or glTF 2.0 file, told apart by the extension: all its parts
/// where their transforms put them, as one mesh; except in PLY, vertices at the same place are one.
/// Units are the file's. Throws InputError if the extension is another, or the file is not what it
/// says or has no triangle.
TriangleMesh read_mesh(const std::filesystem::path& path);

/// A mesh and what its file is called, less the ending.
struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

/// The meshes of a folder.
struct MeshFolder {
  std::vector<NamedMesh> meshes;      ///< by name
  std::vector<std::string> warnings;  ///< a sentence per file that was not used
};

/// All meshes in a folder; files that cannot be read are skipped with a warning, and of files that
/// differ only in their extension one is used.
/// Throws InputError if `dir` is no folder or holds no mesh that can be read.
MeshFolder read_mesh_folder(const std::filesystem::path& dir);

/// A mesh from bytes; files that they refer to are not looked for. `extension` is "ply", "obj",
/// "stl", "glb" or "gltf"; `name` stands for the file in messages.
TriangleMesh parse_mesh(std::string_view bytes, const std::string& extension,
                        const std::string& name);

}  // namespace symscene
