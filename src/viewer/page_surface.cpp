#include "symscene/viewer/page_surface.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/mesh_thinning.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr Index max_probes = 2000;  // points of the cloud that are tested against the surface

/// The points of all objects, or of the whole cloud if there is no object.
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

/// Share of the points that have a vertex within reach.
double share_on(const TriangleMesh& surface, const Points& points, float reach, const Ball& ball) {
  if (surface.vertices.rows() == 0) return 0.0;
  // Bounds the number of cells for a cloud of any extent.
  const CellList cells(surface.vertices, std::max(reach, 0.005F * ball.radius));
  const PointIndices probed = evenly_spread(static_cast<Index>(points.rows()), max_probes);
  const auto found = std::count_if(probed.begin(), probed.end(), [&](Index i) {
    return cells.nearest(points.row(i).transpose(), reach).first != CellList::none;
  });
  return static_cast<double>(found) / static_cast<double>(probed.size());
}

}  // namespace

TriangleMesh page_surface(const TriangleMesh& surface, const SegmentationResult& result,
                          const PageSurfaceOptions& options) {
  options.validate();
  const Points points = shown_points(result);
  const auto max_triangles = static_cast<Index>(options.max_triangles);
  const auto smallest_cell = static_cast<float>(options.smallest_cell);
  if (points.rows() == 0) return thin(surface, max_triangles, smallest_cell);
  const auto reach = static_cast<float>(options.reach);
  const Ball ball = ball_around(points, static_cast<float>(options.margin));
  const TriangleMesh around = crop(surface, ball);
  const double share = share_on(around, points, reach, ball);
  if (share < 0.5) {
    throw InputError(
        "the surface",
        fmt::format("one that the cloud lies on, within {:.0f} mm", 1e3 * options.reach),
        fmt::format("{:.0f} % of its points there", 100.0 * share));
  }
  return thin(around, max_triangles, smallest_cell);
}

}  // namespace symscene
