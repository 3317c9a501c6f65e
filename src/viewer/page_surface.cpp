#include "symscene/viewer/page_surface.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/mesh_thinning.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr Index probes = 2000;  // points of the cloud that are looked up on the surface

/// What the view is about: the objects' points, or all where there is no object.
Points shown_points(const SegmentationResult& result) {
  PointIndices indices;
  for (const SceneObject& object : result.objects) {
    for (const Index i : object.points) {
      if (i < result.cloud.size()) indices.push_back(i);
    }
  }
  const PointCloud shown = indices.empty() ? result.cloud : select(result.cloud, indices);
  return select(shown, finite_points(shown.positions)).positions;
}

Ball ball_around(const Points& points, float margin) {
  const Box box = bounding_box(points);
  const Eigen::Vector3f center = 0.5F * (box.min + box.max);
  const float radius = (points.rowwise() - center.transpose()).rowwise().norm().maxCoeff();
  return {center, radius + margin};
}

/// The share of the points that have a vertex within reach.
double share_on(const TriangleMesh& surface, const Points& points, float reach, const Ball& ball) {
  if (surface.vertices.rows() == 0) return 0.0;
  // Cells in bounds however far the cloud extends.
  const CellList cells(surface.vertices, std::max(reach, 0.005F * ball.radius));
  const PointIndices probed = evenly_spread(static_cast<Index>(points.rows()), probes);
  const auto found = std::count_if(probed.begin(), probed.end(), [&](Index i) {
    return cells.nearest(points.row(i).transpose(), reach).first != CellList::none;
  });
  return static_cast<double>(found) / static_cast<double>(probed.size());
}

}  // namespace

void PageSurfaceOptions::validate() const {
  require_option(margin >= 0.0F, "margin", "a length", margin);
  require_option(max_triangles > 0, "max_triangles", "a number from 1 on", max_triangles);
  require_option(smallest_cell > 0.0F, "smallest_cell", "a length above 0", smallest_cell);
  require_option(reach > 0.0F, "reach", "a length above 0", reach);
}

TriangleMesh page_surface(const TriangleMesh& surface, const SegmentationResult& result,
                          const PageSurfaceOptions& options) {
  options.validate();
  const Points points = shown_points(result);
  if (points.rows() == 0) return {};
  const Ball ball = ball_around(points, options.margin);
  const TriangleMesh around = crop(surface, ball);
  const double share = share_on(around, points, options.reach, ball);
  if (share < 0.5) {
    throw InputError(
        "the surface",
        fmt::format("one that the cloud lies on, within {:.0f} mm", 1e3F * options.reach),
        fmt::format("{:.0f} % of its points there", 100.0 * share));
  }
  return thin(around, options.max_triangles, options.smallest_cell);
}

}  // namespace symscene
