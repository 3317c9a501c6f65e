#include "surface_points.hpp"

namespace symscene {
namespace {

void append_oriented(const PointCloud& cloud, SurfacePoints& points) {
  if (!cloud.has_normals()) return;
  for (Index i = 0; i < cloud.size(); ++i) {
    const float length = cloud.normal(i).norm();
    if (!cloud.position(i).allFinite() || !(length > 0.5F)) continue;
    points.positions.push_back(cloud.position(i));
    points.normals.push_back(cloud.normal(i) / length);
  }
}

}  // namespace

SurfacePoints surface_points(const PointCloud& observed, const PointCloud& added) {
  SurfacePoints points;
  append_oriented(observed, points);
  points.observed = points.size();
  append_oriented(added, points);
  return points;
}

}  // namespace symscene
