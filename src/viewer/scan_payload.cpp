#include "scan_payload.hpp"

#include <vector>

#include "base64.hpp"
#include "encoding.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

using nlohmann::json;

constexpr Index path_points = 1000;
constexpr Index shown_cameras = 9;

/// Seven bits a byte, the lowest first; the eighth says that more follow (LEB128).
void append_number(std::vector<std::uint8_t>& bytes, Index number) {
  for (; number >= 0x80; number >>= 7) {
    bytes.push_back(static_cast<std::uint8_t>((number & 0x7F) | 0x80));
  }
  bytes.push_back(static_cast<std::uint8_t>(number));
}

/// Triangles in new names for their vertices: 0, 1, 2 ... as they come up.
struct RenamedTriangles {
  PointIndices vertices;            ///< the old name of each
  std::vector<std::uint8_t> bytes;  ///< for each corner how long ago the newest came up, 0 for new
};

RenamedTriangles rename(const TriangleMesh& mesh) {
  constexpr Index none = ~Index{0};
  std::vector<Index> name_of(static_cast<std::size_t>(mesh.vertices.rows()), none);
  RenamedTriangles renamed;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Index corner = mesh.triangles(t, k);
      const auto next = static_cast<Index>(renamed.vertices.size());
      if (name_of[corner] == none) {
        name_of[corner] = next;
        renamed.vertices.push_back(corner);
      }
      append_number(renamed.bytes, next - name_of[corner]);
    }
  }
  return renamed;
}

/// Right, down and forward are the axes of a camera.
json camera_payload(const Eigen::Isometry3d& T_world_camera) {
  return {{"position", encode(T_world_camera.translation())},
          {"right", encode(T_world_camera.linear().col(0))},
          {"down", encode(T_world_camera.linear().col(1))},
          {"forward", encode(T_world_camera.linear().col(2))}};
}

}  // namespace

json surface_payload(const TriangleMesh& surface) {
  if (surface.triangles.rows() == 0) return nullptr;
  const RenamedTriangles renamed = rename(surface);
  const PointCloud vertices = select({surface.vertices, {}, surface.colors}, renamed.vertices);
  return {{"positions", encode_positions(vertices.positions)},
          {"colors", encode_colors(vertices.colors)},
          {"triangles", {{"count", surface.triangles.rows()}, {"data", base64(renamed.bytes)}}}};
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
