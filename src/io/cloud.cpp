#include "symscene/io/cloud.hpp"

#include "io/atomic_file.hpp"
#include "io/ply.hpp"
#include "pcd.hpp"
#include "pcd_header.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {

PointCloud read_cloud(const std::filesystem::path& path) { return read_sensor_cloud(path).cloud; }

SensorCloud read_sensor_cloud(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  const std::string_view first_line = std::string_view(bytes).substr(0, bytes.find('\n'));
  if (first_line.starts_with("ply")) return {parse_ply_cloud(bytes, path.string())};
  if (first_line.starts_with("#") || first_line.starts_with("VERSION")) {
    return {parse_pcd(bytes, path.string()), parse_pcd_header(bytes, path.string()).viewpoint};
  }
  throw InputError(path.string(), "a point cloud in PLY or PCD format",
                   bytes.empty() ? "an empty file" : in_quotes(first_line));
}

void write_cloud(const std::filesystem::path& path, const PointCloud& cloud) {
  const std::filesystem::path extension = path.extension();
  if (extension != ".ply" && extension != ".pcd")
    throw InputError(path.string(), "a name that ends in .ply or .pcd", extension.string());
  write_file_atomically(path, extension == ".ply" ? format_ply(cloud) : format_pcd(cloud));
}

}  // namespace symscene
