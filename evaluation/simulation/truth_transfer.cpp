#include "symscene/simulation/truth_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "core/image_checks.hpp"
#include "core/nearest_orthogonal.hpp"
#include "core/parallel.hpp"
#include "core/pixel_showing.hpp"
#include "core/thinned_size.hpp"
#include "simulation/shapes.hpp"
#include "simulation/true_surface.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Per point the object whose surface it is on, or none.
std::vector<Index> nearest_objects(const Points& points_truth, const SceneTruth& truth,
                                   const TrueSurface& surface, double tolerance) {
  std::vector<Index> objects(static_cast<std::size_t>(points_truth.rows()));
  constexpr std::size_t block = 1024;
  parallel_for_blocks(objects.size(), block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d p =
          points_truth.row(static_cast<Eigen::Index>(i)).transpose().cast<double>();
      objects[i] = TrueSurface::Nearest::nothing;
      const double limit = std::min(tolerance, std::abs(truth.table.signed_distance(p)));
      if (p.allFinite()) objects[i] = surface.nearest(p, limit).mesh;
    }
  });
  return objects;
}

Points in_truth_frame(const Points& points, const Eigen::Isometry3d& T) {
  return ((points.cast<double>() * T.linear().transpose()).rowwise() + T.translation().transpose())
      .cast<float>();
}

/// The object that a view shows at a point, `nothing` for what is none; none where it did not
/// measure the point.
std::optional<Index> object_shown(const LabelledView& view, const Eigen::Vector3d& point_camera,
                                  const CameraIntrinsics& camera, double tolerance) {
  const std::optional<Eigen::Vector2i> pixel = projected_pixel(point_camera, camera);
  if (!pixel) return std::nullopt;
  const auto at =
      static_cast<std::size_t>(pixel->y()) * camera.width + static_cast<std::size_t>(pixel->x());
  const double z = point_camera.z();
  if (std::abs(double{view.depth[at]} - z) > tolerance * std::max(1.0, z * z)) return std::nullopt;
  return view.objects[at];
}

/// The object that most views show at a point; the first of several.
Index object_of_most(const LabelledSweep& sweep, const Eigen::Vector3d& point, double tolerance) {
  std::map<Index, int> votes;
  for (const LabelledView& view : sweep.views) {
    const auto shown = object_shown(view, view.T_camera_cloud * point, sweep.camera, tolerance);
    if (shown) ++votes[*shown];
  }
  const auto most = std::max_element(
      votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == votes.end() ? SensorFrame::nothing : most->first;
}

/// `truth` in the frame of `cloud`, with the points of each object that has enough of them.
/// `objects` is the index of each point's object, or a greater one.
SceneTruth with_masks(SceneTruth truth, const std::vector<Index>& objects, const PointCloud& cloud,
                      const TruthTransferOptions& options) {
  std::vector<PointIndices> masks(truth.objects.size());
  for (Index i = 0; i < objects.size(); ++i) {
    if (objects[i] < masks.size()) masks[objects[i]].push_back(i);
  }
  std::vector<TrueObject> seen;
  for (std::size_t k = 0; k < masks.size(); ++k) {
    if (thinned_size(cloud.positions, masks[k]) <
        static_cast<std::size_t>(options.min_object_points)) {
      continue;
    }
    seen.push_back(std::move(truth.objects[k]));
    seen.back().points = std::move(masks[k]);
  }
  truth.objects = std::move(seen);
  return truth;
}

}  // namespace

SceneTruth transformed(SceneTruth truth, const Eigen::Isometry3d& T_to_truth) {
  const Eigen::Isometry3d& T = T_to_truth;
  truth.table = transformed(truth.table, T);
  for (TrueObject& object : truth.objects) {
    object.centroid = T * object.centroid;
    if (object.T_world_mesh) object.T_world_mesh = T * *object.T_world_mesh;
    for (TrueAxis& own : object.rotational)
      own.axis = {T * own.axis.point, T.linear() * own.axis.direction};
    for (TruePlane& own : object.reflectional)
      own.plane = {T * own.plane.point, T.linear() * own.plane.normal};
  }
  return truth;
}

Eigen::Isometry3d align_poses(std::span<const Eigen::Isometry3d> poses_target,
                              std::span<const Eigen::Isometry3d> poses_source) {
  if (poses_target.size() != poses_source.size()) {
    throw InputError("poses to align", fmt::format("{}", poses_target.size()),
                     fmt::format("{}", poses_source.size()));
  }
  if (poses_target.empty()) return Eigen::Isometry3d::Identity();
  Eigen::Matrix3d rotations = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < poses_target.size(); ++i)
    rotations += poses_target[i].linear() * poses_source[i].linear().transpose();
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  T_target_source.linear() = nearest_rotation(rotations);
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < poses_target.size(); ++i)
    shift +=
        poses_target[i].translation() - T_target_source.linear() * poses_source[i].translation();
  T_target_source.translation() = shift / static_cast<double>(poses_target.size());
  return T_target_source;
}

std::vector<TriangleMesh> placed_meshes(const SceneTruth& truth,
                                        std::span<const TriangleMesh> meshes) {
  if (meshes.size() != truth.objects.size()) {
    throw InputError("the ground truth",
                     fmt::format("{} meshes, one per object", truth.objects.size()),
                     fmt::format("{}", meshes.size()));
  }
  std::vector<TriangleMesh> placed;
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const TrueObject& object = truth.objects[k];
    if (!object.T_world_mesh)
      throw InputError("the ground truth", "a pose of " + object.name, "none");
    placed.push_back(transformed(meshes[k], *object.T_world_mesh));
  }
  return placed;
}

SceneTruth transfer_truth(const SceneTruth& truth, std::span<const TriangleMesh> meshes,
                          const PointCloud& cloud, const Eigen::Isometry3d& T_cloud_truth,
                          const TruthTransferOptions& options) {
  options.validate();
  const TrueSurface surface(placed_meshes(truth, meshes));
  const std::vector<Index> objects = nearest_objects(
      in_truth_frame(cloud.positions, T_cloud_truth.inverse()), truth, surface, options.tolerance);
  return with_masks(transformed(truth, T_cloud_truth), objects, cloud, options);
}

SceneTruth view_truth(const SceneTruth& truth, const SensorFrame& frame,
                      const CameraIntrinsics& camera, const PointCloud& cloud_camera,
                      const TruthTransferOptions& options) {
  options.validate();
  require_pixels(frame.depth.size(), camera, "depth image");
  require_pixels(frame.objects.size(), camera, "image of objects");
  std::vector<Index> objects(cloud_camera.size(), SensorFrame::nothing);
  for (Index i = 0; i < cloud_camera.size(); ++i) {
    const auto pixel = pixel_showing(cloud_camera.position(i).cast<double>(), frame.depth, camera);
    if (pixel) objects[i] = frame.objects[*pixel];
  }
  return with_masks(transformed(truth, frame.T_world_camera.inverse()), objects, cloud_camera,
                    options);
}

SceneTruth sweep_truth(const SceneTruth& truth, const LabelledSweep& sweep, const PointCloud& cloud,
                       const Eigen::Isometry3d& T_cloud_truth,
                       const TruthTransferOptions& options) {
  options.validate();
  for (const LabelledView& view : sweep.views) {
    require_pixels(view.depth.size(), sweep.camera, "depth image");
    require_pixels(view.objects.size(), sweep.camera, "image of objects");
  }
  std::vector<Index> objects(cloud.size(), SensorFrame::nothing);
  parallel_for_each(objects.size(), [&](std::size_t i) {
    const Eigen::Vector3d point = cloud.position(static_cast<Index>(i)).cast<double>();
    objects[i] = object_of_most(sweep, point, options.tolerance);
  });
  return with_masks(transformed(truth, T_cloud_truth), objects, cloud, options);
}

}  // namespace symscene
