#include "symscene/io/mesh.hpp"

#include <algorithm>
#include <cctype>

#include "io/assimp_mesh.hpp"
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

void require_known(const std::string& extension, const std::string& name) {
  for (const char* known : {"ply", "obj", "stl", "glb", "gltf"}) {
    if (extension == known) return;
  }
  throw InputError(name, "a mesh in PLY, OBJ, STL, GLB or glTF format",
                   extension.empty() ? "no extension" : "." + extension);
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  require_known(extension, path.string());
  if (extension == "ply") return read_ply_mesh(path);
  return load_with_assimp(path);
}

TriangleMesh parse_mesh(std::string_view bytes, const std::string& extension,
                        const std::string& name) {
  require_known(extension, name);
  if (extension == "ply") return parse_ply_mesh(bytes, name);
  return parse_with_assimp(bytes, extension, name);
}

}  // namespace symscene
