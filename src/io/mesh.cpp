#include "symscene/io/mesh.hpp"

#include <algorithm>

#include "io/mesh_formats.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/atomic_file.hpp"
#include "symscene/io/ply.hpp"

namespace symscene {
namespace {

std::string lower_case_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

TriangleMesh parse(std::string_view bytes, const std::string& extension, const std::string& name,
                   const ReadBeside& read_beside) {
  if (extension == "ply") return parse_ply_mesh(bytes, name);
  if (extension == "obj") return parse_obj(bytes, name);
  if (extension == "stl") return parse_stl(bytes, name);
  if (extension == "glb" || extension == "gltf") return parse_gltf(bytes, name, read_beside);
  throw InputError(name, "a mesh in PLY, OBJ, STL, GLB or glTF format",
                   extension.empty() ? "no extension" : "." + extension);
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path) {
  const ReadBeside read_beside = [&](const std::string& relative) {
    return read_file(path.parent_path() / relative);
  };
  return parse(read_file(path), lower_case_extension(path), path.string(), read_beside);
}

TriangleMesh parse_mesh(std::string_view bytes, const std::string& extension,
                        const std::string& name) {
  const ReadBeside read_nothing = [&](const std::string& relative) -> std::string {
    throw InputError(name, "a file that stands for itself", "one that refers to " + relative);
  };
  return parse(bytes, extension, name, read_nothing);
}

}  // namespace symscene
