#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Reads a PLY, OBJ, STL, GLB or glTF 2.0 file, recognised by the extension. All parts, placed by
/// their transforms, are joined into one mesh; except in PLY, vertices at equal positions are
/// merged. Units are those of the file. Throws InputError if the extension is another, or the file
/// is not valid or has no triangle.
TriangleMesh read_mesh(const std::filesystem::path& path);

/// Writes a PLY file, little-endian, atomically.
/// Throws InputError if normals or colours are not as many as the vertices, or the file cannot be
/// written.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh);

/// A mesh and the name of its file without the extension.
struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

/// The meshes of a folder.
struct MeshFolder {
  std::vector<NamedMesh> meshes;      ///< by name
  std::vector<std::string> warnings;  ///< one sentence per file that was not used
};

/// All meshes in a folder; files that cannot be read are skipped with a warning, and of files that
/// differ only in their extension one is used.
/// Throws InputError if `dir` is not a folder or has no readable mesh.
MeshFolder read_mesh_folder(const std::filesystem::path& dir);

/// Parses a mesh from bytes; references to other files are refused (glTF) or ignored (OBJ).
/// `extension` is "ply", "obj", "stl", "glb" or "gltf"; `name` is the name of the file in messages.
/// Throws InputError as read_mesh() does.
TriangleMesh parse_mesh(std::string_view bytes, const std::string& extension,
                        const std::string& name);

}  // namespace symscene
