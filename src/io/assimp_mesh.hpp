#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The only door to Assimp: OBJ, STL, GLB and glTF. Throws InputError.
TriangleMesh load_with_assimp(const std::filesystem::path& path);
TriangleMesh parse_with_assimp(std::string_view bytes, const std::string& extension,
                               const std::string& name);

}  // namespace symscene
