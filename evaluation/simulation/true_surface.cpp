#include "simulation/true_surface.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

#include "core/parallel.hpp"
#include "embree_scene.hpp"

namespace symscene {
namespace {

/// The point nearest to `p` on the segment from a to b.
Eigen::Vector3d nearest_on_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                   const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp(along.dot(p - a) / length2, 0.0, 1.0) : 0.0;
  return a + t * along;
}

/// The squared distance to a triangle: to its plane where the foot lies inside, else to an edge.
double squared_distance(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double area2 = normal.squaredNorm();
  const auto is_inside = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return normal.dot((to - from).cross(p - from)) >= 0.0;
  };
  if (area2 > 0.0 && is_inside(a, b) && is_inside(b, c) && is_inside(c, a)) {
    const double height = normal.dot(p - a);
    return height * height / area2;
  }
  return std::min({(p - nearest_on_segment(p, a, b)).squaredNorm(),
                   (p - nearest_on_segment(p, b, c)).squaredNorm(),
                   (p - nearest_on_segment(p, c, a)).squaredNorm()});
}

struct Search {
  const EmbreeScene* scene;
  Eigen::Vector3d point;
  double best2;
  Index mesh = TrueSurface::Nearest::nothing;
};

/// Embree's search radius is slightly larger than the best distance, so that rounding excludes no
/// triangle.
float radius_beyond(double squared_distance) {
  return static_cast<float>(std::sqrt(squared_distance) * (1.0 + 1e-6)) + 1e-9F;
}

bool visit_triangle(RTCPointQueryFunctionArguments* arguments) {
  auto& search = *static_cast<Search*>(arguments->userPtr);
  const double distance2 =
      squared_distance(search.point, search.scene->corners(arguments->geomID, arguments->primID));
  const bool is_tie = distance2 == search.best2 && arguments->geomID < search.mesh;
  if (!(distance2 < search.best2) && !is_tie) return false;
  search.best2 = distance2;
  search.mesh = arguments->geomID;
  arguments->query->radius = radius_beyond(distance2);
  return true;
}

double quantile(std::vector<float> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace

struct TrueSurface::Implementation : EmbreeScene {
  using EmbreeScene::EmbreeScene;
};

TrueSurface::TrueSurface(std::span<const TriangleMesh> meshes)
    : implementation_(std::make_unique<Implementation>(meshes)) {}
TrueSurface::~TrueSurface() = default;
TrueSurface::TrueSurface(TrueSurface&&) noexcept = default;
TrueSurface& TrueSurface::operator=(TrueSurface&&) noexcept = default;

TrueSurface::Nearest TrueSurface::nearest(const Eigen::Vector3d& point, double radius) const {
  Search search{implementation_.get(), point, radius * radius};
  RTCPointQuery query{};
  query.x = static_cast<float>(point.x());
  query.y = static_cast<float>(point.y());
  query.z = static_cast<float>(point.z());
  query.radius = radius_beyond(search.best2);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(implementation_->scene(), &query, &context, visit_triangle, &search);
  return {search.mesh, std::sqrt(search.best2)};
}

SurfaceErrors surface_errors(const Points& points, std::span<const TriangleMesh> meshes,
                             const std::optional<Plane>& table, double reach) {
  const TrueSurface surface(meshes);
  SurfaceErrors errors;
  errors.distances.resize(static_cast<std::size_t>(points.rows()));
  constexpr std::size_t block = 1024;
  parallel_for_blocks(errors.distances.size(), block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d p = points.row(static_cast<Eigen::Index>(i)).transpose().cast<double>();
      const double limit = table ? std::min(reach, std::abs(table->signed_distance(p))) : reach;
      errors.distances[i] = static_cast<float>(surface.nearest(p, limit).distance);
    }
  });
  errors.median = quantile(errors.distances, 0.5);
  errors.percentile_90 = quantile(errors.distances, 0.9);
  errors.percentile_95 = quantile(errors.distances, 0.95);
  const auto within = std::count_if(errors.distances.begin(), errors.distances.end(),
                                    [&](float d) { return d < static_cast<float>(reach); });
  if (!errors.distances.empty())
    errors.within_reach =
        static_cast<double>(within) / static_cast<double>(errors.distances.size());
  return errors;
}

}  // namespace symscene
