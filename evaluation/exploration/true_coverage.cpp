#include "true_coverage.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/surface_sampling.hpp"
#include "symscene/clutter/clutter_world.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr float reach = 0.005F;       // within which surface is covered [m]
constexpr double label_reach = 0.01;  // of a point from the object that it is on [m]
constexpr double spacing = 0.003;     // of places on surfaces [m]
constexpr std::size_t places_per_mesh = 2000;

void append(Points& all, const Points& more) {
  const Eigen::Index before = all.rows();
  all.conservativeResize(before + more.rows(), 3);
  all.bottomRows(more.rows()) = more;
}

/// Surface on which an object stands can be seen by no camera.
bool rests_on_table(const PointCloud& places, Index i) {
  return places.normal(i).z() < 0.0F &&
         places.position(i).z() < static_cast<float>(clutter::table_height) + reach;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(1, values.size()));
}

}  // namespace

TrueCoverage::TrueCoverage(std::vector<TriangleMesh> objects)
    : meshes_(std::move(objects)), surface_(meshes_), renderer_(meshes_) {
  places_.positions.resize(0, 3);
  places_.normals.resize(0, 3);
  for (Index mesh = 0; mesh < meshes_.size(); ++mesh) {
    const PointCloud samples = sample_surface(meshes_[mesh], places_per_mesh);
    PointIndices kept;
    for (Index i = 0; i < samples.size(); ++i) {
      if (!rests_on_table(samples, i)) kept.push_back(i);
    }
    append(places_.positions, samples.positions(kept, Eigen::all));
    append(places_.normals, samples.normals(kept, Eigen::all));
    objects_.resize(places_.size(), mesh);
  }
}

std::vector<std::uint8_t> TrueCoverage::near(const Points& points) const {
  std::vector<std::uint8_t> is_near(places_.size(), 0);
  if (points.rows() == 0) return is_near;
  const CellList cells(points, reach);
  for (Index i = 0; i < places_.size(); ++i)
    is_near[i] = cells.nearest(places_.position(i), reach).first != CellList::none ? 1 : 0;
  return is_near;
}

std::vector<double> TrueCoverage::shares(const Points& points) const {
  const std::vector<std::uint8_t> is_near = near(points);
  std::vector<double> covered(meshes_.size(), 0.0), all(meshes_.size(), 0.0);
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    covered[objects_[i]] += is_near[i];
    all[objects_[i]] += 1.0;
  }
  for (std::size_t k = 0; k < covered.size(); ++k) covered[k] /= std::max(1.0, all[k]);
  return covered;
}

double TrueCoverage::mean_share(const Points& points) const { return mean(shares(points)); }

double TrueCoverage::observed(const Scene& scene) const {
  return mean_share(scene.cloud.positions);
}

double TrueCoverage::completed(const Scene& scene, const SegmentationResult& result) const {
  Points points = scene.cloud.positions;
  for (const ObjectSurface& surface : result.surfaces)
    append(points, sample_surface_at(surface.mesh, spacing).positions);
  return mean_share(points);
}

DetectionCounts TrueCoverage::masks(const SegmentationResult& result) const {
  std::vector<PointIndices> truth(meshes_.size()), found;
  for (Index i = 0; i < result.cloud.size(); ++i) {
    const auto nearest = surface_.nearest(result.cloud.position(i).cast<double>(), label_reach);
    if (nearest.mesh != TrueSurface::Nearest::nothing) truth[nearest.mesh].push_back(i);
  }
  for (const SceneObject& object : result.objects) found.push_back(object.points);
  constexpr double min_overlap = 0.75;
  return mask_detections(overlap_matrix(truth, found), min_overlap);
}

PointIndices TrueCoverage::uncovered(const Points& points) const {
  const std::vector<std::uint8_t> is_near = near(points);
  PointIndices places;
  for (Index i = 0; i < places_.size(); ++i) {
    if (is_near[i] == 0) places.push_back(i);
  }
  return places;
}

std::size_t TrueCoverage::count_visible(const PointIndices& places, const CameraIntrinsics& camera,
                                        const Eigen::Isometry3d& T_world_camera) const {
  const std::vector<float> depth = renderer_.render(camera, T_world_camera).depth;
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse();
  std::size_t count = 0;
  for (const Index i : places) {
    const Eigen::Vector3d at = T_camera_world * places_.position(i).cast<double>();
    const Eigen::Vector2d pixel = camera.project(at);
    const auto u = static_cast<std::ptrdiff_t>(std::lround(pixel.x()));
    const auto v = static_cast<std::ptrdiff_t>(std::lround(pixel.y()));
    if (!(at.z() > 0.0) || u < 0 || v < 0 || u >= static_cast<std::ptrdiff_t>(camera.width) ||
        v >= static_cast<std::ptrdiff_t>(camera.height))
      continue;
    const auto index = static_cast<std::size_t>(v) * camera.width + static_cast<std::size_t>(u);
    count += std::abs(static_cast<double>(depth[index]) - at.z()) < label_reach ? 1 : 0;
  }
  return count;
}

}  // namespace symscene
