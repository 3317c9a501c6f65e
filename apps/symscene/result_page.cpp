#include "result_page.hpp"

#include <utility>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "symscene/viewer/page_surface.hpp"

namespace symscene::app {

TriangleMesh surface_around(const TriangleMesh& surface, const SegmentationResult& result,
                            const std::filesystem::path& source, Session& session) {
  if (surface.vertices.rows() == 0) return {};
  try {
    return naming(source / "mesh.ply", [&] { return page_surface(surface, result); });
  } catch (const InputError& error) {
    session.warn(fmt::format("{}; it is left out", error.what()));
    return {};
  }
}

std::optional<Eigen::Vector3d> camera_up(const PointCloud& cloud) {
  constexpr float most_aslant = 1.4F;  // tangent of rays' angles with the optical axis
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f p = cloud.position(i);
    if (p.head<2>().norm() > most_aslant * p.z()) return std::nullopt;
  }
  return -Eigen::Vector3d::UnitY();
}

void write_result_page(const std::filesystem::path& page, const std::filesystem::path& source,
                       const SegmentationResult& result, Surroundings around, PageExtras extras) {
  PageOptions options;
  options.noun = std::move(extras.noun);
  options.title = folder_name(source);
  options.table = result.table;
  if (!result.table) options.up = camera_up(result.cloud);
  options.surface = std::move(around.surface);
  options.trajectory = std::move(around.trajectory);
  options.grasps = std::move(extras.grasps);
  options.views = std::move(extras.views);
  write_file_atomically(page, render_page(result, options));
}

}  // namespace symscene::app
