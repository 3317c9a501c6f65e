#include "symscene/io/mesh.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "io/ply.hpp"
#include "mesh_formats.hpp"
#include "symscene/core/error.hpp"

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

bool is_mesh_file(const std::filesystem::path& path) {
  static constexpr std::array<std::string_view, 5> known = {"ply", "obj", "stl", "glb", "gltf"};
  return std::filesystem::is_regular_file(path) &&
         std::find(known.begin(), known.end(), lower_case_extension(path)) != known.end();
}

/// The mesh files of a folder by name, one of each name.
std::vector<std::filesystem::path> mesh_files(const std::filesystem::path& dir,
                                              std::vector<std::string>& warnings) {
  std::map<std::string, std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(dir, error)) {
    if (!is_mesh_file(entry.path())) continue;
    const auto [other, is_new] = files.try_emplace(entry.path().stem().string(), entry.path());
    if (is_new) continue;
    warnings.push_back(fmt::format("{} and {} have one name: only one is used",
                                   entry.path().string(), other->second.string()));
    other->second = std::min(other->second, entry.path());
  }
  if (error) throw InputError(dir.string(), "a folder of meshes", error.message());
  std::vector<std::filesystem::path> paths;
  for (const auto& [name, path] : files) paths.push_back(path);
  return paths;
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path) {
  const ReadBeside read_beside = [&](const std::string& relative) {
    return read_file(path.parent_path() / relative);
  };
  return parse(read_file(path), lower_case_extension(path), path.string(), read_beside);
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh) {
  write_file_atomically(path, format_ply(mesh));
}

MeshFolder read_mesh_folder(const std::filesystem::path& dir) {
  MeshFolder folder;
  for (const std::filesystem::path& file : mesh_files(dir, folder.warnings)) {
    try {
      folder.meshes.push_back({file.stem().string(), read_mesh(file)});
    } catch (const InputError& error) {
      folder.warnings.push_back(fmt::format("not used: {}", error.what()));
    }
  }
  if (folder.meshes.empty())
    throw InputError(dir.string(), "a folder of meshes (PLY, OBJ, STL, GLB, glTF)", "none in it");
  return folder;
}

TriangleMesh parse_mesh(std::string_view bytes, const std::string& extension,
                        const std::string& name) {
  const ReadBeside read_nothing = [&](const std::string& relative) -> std::string {
    throw InputError(name, "a file without references to others", "one to " + relative);
  };
  return parse(bytes, extension, name, read_nothing);
}

}  // namespace symscene
