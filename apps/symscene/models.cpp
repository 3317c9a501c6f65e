#include "models.hpp"

#include <algorithm>
#include <cctype>

#include "io/atomic_file.hpp"

namespace symscene::app {
namespace {

/// Whether the header of a PLY file announces at least one face.
bool ply_has_faces(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  const std::string header = bytes.substr(0, bytes.find("end_header"));
  const std::string element = "element face ";
  const std::size_t at = header.find(element);
  return at != std::string::npos && header[at + element.size()] != '0';
}

}  // namespace

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool is_cloud_file(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".pcd" || (extension == ".ply" && !ply_has_faces(path));
}

}  // namespace symscene::app
