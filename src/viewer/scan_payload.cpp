#include "scan_payload.hpp"

#include <vector>

#include "core/base64.hpp"
#include "core/mesh_thinning.hpp"
#include "encoding.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

using nlohmann::json;

constexpr Index path_points = 1000;
constexpr Index shown_cameras = 9;
constexpr float closed_cell = 0.003F;  // of thinned closed surfaces [m]

/// LEB128: seven bits per byte, lowest first; the eighth bit is set if more bytes follow.
void append_number(std::vector<std::uint8_t>& bytes, Index number) {
  for (; number >= 0x80; number >>= 7) {
    bytes.push_back(static_cast<std::uint8_t>((number & 0x7F) | 0x80));
  }
  bytes.push_back(static_cast<std::uint8_t>(number));
}

/// Triangles whose vertices are numbered in the order of their first use.
struct RenumberedTriangles {
  PointIndices vertices;            ///< the original index of each vertex
  std::vector<std::uint8_t> bytes;  ///< per corner the next new index minus its index; 0 if new
};

RenumberedTriangles renumber(const TriangleMesh& mesh) {
  constexpr Index none = ~Index{0};
  std::vector<Index> index_of(static_cast<std::size_t>(mesh.vertices.rows()), none);
  RenumberedTriangles renumbered;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Index corner = mesh.triangles(t, k);
      const auto next = static_cast<Index>(renumbered.vertices.size());
      if (index_of[corner] == none) {
        index_of[corner] = next;
        renumbered.vertices.push_back(corner);
      }
      append_number(renumbered.bytes, next - index_of[corner]);
    }
  }
  return renumbered;
}

}  // namespace

json camera_payload(const Eigen::Isometry3d& T_world_camera) {
  return {{"position", encode(T_world_camera.translation())},
          {"right", encode(T_world_camera.linear().col(0))},
          {"down", encode(T_world_camera.linear().col(1))},
          {"forward", encode(T_world_camera.linear().col(2))}};
}

json surface_payload(const TriangleMesh& surface) {
  if (surface.triangles.rows() == 0) return nullptr;
  const RenumberedTriangles renumbered = renumber(surface);
  const PointCloud vertices = select({surface.vertices, {}, surface.colors}, renumbered.vertices);
  return {{"positions", encode_positions(vertices.positions)},
          {"colors", encode_colors(vertices.colors)},
          {"triangles", {{"count", surface.triangles.rows()}, {"data", base64(renumbered.bytes)}}}};
}

json closed_payload(const ObjectSurface& surface, Index max_triangles) {
  if (surface.mesh.triangles.rows() == 0) return nullptr;
  TriangleMesh shaded = surface.mesh;
  shaded.colors = Colors::Zero(shaded.vertices.rows(), 3);
  for (Eigen::Index t = 0; t < shaded.triangles.rows(); ++t) {
    if (surface.observed[static_cast<std::size_t>(t)] == 0) continue;
    for (Eigen::Index k = 0; k < 3; ++k) shaded.colors.row(shaded.triangles(t, k)).setConstant(255);
  }
  return surface_payload(thin(shaded, max_triangles, closed_cell));
}

json trajectory_payload(const Trajectory& trajectory) {
  if (trajectory.empty()) return nullptr;
  const auto size = static_cast<Index>(trajectory.size());
  const PointIndices on_path = evenly_spread(size, path_points);
  Points path(static_cast<Eigen::Index>(on_path.size()), 3);
  for (Eigen::Index row = 0; row < path.rows(); ++row) {
    const StampedPose& pose = trajectory[on_path[static_cast<std::size_t>(row)]];
    path.row(row) = pose.T_world_camera.translation().cast<float>().transpose();
  }
  json cameras = json::array();
  for (const Index i : evenly_spread(size, shown_cameras)) {
    cameras.push_back(camera_payload(trajectory[i].T_world_camera));
  }
  return {{"frames", size}, {"path", encode_positions(path)}, {"cameras", cameras}};
}

}  // namespace symscene
