#include <fmt/format.h>

#include "cloud_checks.hpp"
#include "io/atomic_file.hpp"
#include "io/ply.hpp"
#include "ply_points.hpp"
#include "scalar.hpp"

namespace symscene {
namespace {

constexpr const char* normal_properties =
    "property float nx\nproperty float ny\nproperty float nz\n";
constexpr const char* color_properties =
    "property uchar red\nproperty uchar green\nproperty uchar blue\n";

std::string header_begin(Eigen::Index vertices) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n",
      vertices);
}

void append_row(std::string& out, const Points& points, Eigen::Index i) {
  for (Eigen::Index k = 0; k < 3; ++k) append_scalar(out, points(i, k));
}

void append_row(std::string& out, const Colors& colors, Eigen::Index i) {
  for (Eigen::Index k = 0; k < 3; ++k) append_scalar(out, colors(i, k));
}

}  // namespace

std::string format_ply_marked(const PointCloud& cloud, std::span<const std::uint8_t> observed) {
  require_consistent(cloud, "point cloud to write");
  std::string out = header_begin(cloud.positions.rows());
  if (cloud.has_normals()) out += normal_properties;
  if (cloud.has_colors()) out += color_properties;
  if (!observed.empty()) out += "property uchar observed\n";
  out += "end_header\n";
  out.reserve(out.size() + 28 * static_cast<std::size_t>(cloud.size()));
  for (Eigen::Index i = 0; i < cloud.positions.rows(); ++i) {
    append_row(out, cloud.positions, i);
    if (cloud.has_normals()) append_row(out, cloud.normals, i);
    if (cloud.has_colors()) append_row(out, cloud.colors, i);
    if (!observed.empty()) append_scalar(out, observed[static_cast<std::size_t>(i)]);
  }
  return out;
}

std::string format_ply(const PointCloud& cloud) { return format_ply_marked(cloud, {}); }

std::string format_ply(const TriangleMesh& mesh) {
  require_consistent({mesh.vertices, mesh.normals, mesh.colors}, "mesh to write");
  std::string out = header_begin(mesh.vertices.rows());
  const bool has_normals = mesh.normals.rows() != 0, has_colors = mesh.colors.rows() != 0;
  if (has_normals) out += normal_properties;
  if (has_colors) out += color_properties;
  out += fmt::format("element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
                     mesh.triangles.rows());
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    append_row(out, mesh.vertices, i);
    if (has_normals) append_row(out, mesh.normals, i);
    if (has_colors) append_row(out, mesh.colors, i);
  }
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    append_scalar(out, std::uint8_t{3});
    for (Eigen::Index k = 0; k < 3; ++k) append_scalar(out, mesh.triangles(t, k));
  }
  return out;
}

}  // namespace symscene
