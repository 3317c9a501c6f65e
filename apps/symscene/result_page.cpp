#include "result_page.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/naming.hpp"
#include "io/atomic_file.hpp"
#include "symscene/viewer/page_surface.hpp"

namespace symscene::app {
namespace {

/// The direction that a page without a table shows upwards: −y for a cloud that lies before a
/// camera at the origin that looks along +z; none for others.
std::optional<Eigen::Vector3d> camera_up(const PointCloud& cloud) {
  constexpr float most_aslant = 1.4F;  // tangent of rays' angles with the optical axis
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f p = cloud.position(i);
    if (p.head<2>().norm() > most_aslant * p.z()) return std::nullopt;
  }
  return -Eigen::Vector3d::UnitY();
}

}  // namespace

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

PageOptions result_page(const SegmentationResult& result, std::string title, Surroundings around) {
  PageOptions options;
  options.title = std::move(title);
  options.table = result.table;
  if (!result.table) options.up = camera_up(result.cloud);
  options.surface = std::move(around.surface);
  options.trajectory = std::move(around.trajectory);
  return options;
}

void write_result_page(const std::filesystem::path& page, const std::filesystem::path& source,
                       const SegmentationResult& result, Surroundings around, PageExtras extras) {
  std::string title = folder_name(source);
  if (!extras.subject.empty()) title += fmt::format(": {}", extras.subject);
  PageOptions options = result_page(result, std::move(title), std::move(around));
  options.noun = std::move(extras.noun);
  options.grasps = std::move(extras.grasps);
  options.views = std::move(extras.views);
  options.truth = std::move(extras.truth);
  write_file_atomically(page, render_page(result, options));
}

}  // namespace symscene::app
