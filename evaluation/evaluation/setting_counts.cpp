#include "setting_counts.hpp"

#include <algorithm>

namespace symscene {
namespace {

/// Ground truth of masks alone has no symmetries to compare with.
bool knows_symmetries(const SceneTruth& truth) {
  return truth.objects.empty() ||
         std::any_of(truth.objects.begin(), truth.objects.end(), [](const TrueObject& object) {
           return object.sphere || !object.rotational.empty() || !object.reflectional.empty();
         });
}

std::vector<PointIndices> masks_of(const std::vector<SceneObject>& objects) {
  std::vector<PointIndices> masks;
  for (const SceneObject& object : objects) masks.push_back(object.points);
  return masks;
}

}  // namespace

SettingCounts count_symmetries(const SceneTruth& truth, const std::vector<RotationAxis>& axes,
                               const std::vector<ReflectionPlane>& planes) {
  const SymmetryTolerance wide{radians(10.0), 0.1};
  const SymmetryTolerance near{radians(10.0), 0.01};
  SettingCounts counts;
  counts.scenes = 1;
  if (!knows_symmetries(truth)) return counts;
  counts.detections(Metric::axes) = match_axes(truth, axes, wide).detections();
  counts.detections(Metric::axes_near) = match_axes(truth, axes, near).detections();
  counts.detections(Metric::planes) = match_planes(truth, planes, wide).detections();
  counts.detections(Metric::planes_near) = match_planes(truth, planes, near).detections();
  return counts;
}

CountingContext::CountingContext(const Scene& scene, const SceneTruth& truth,
                                 const PointCloud& cloud, const EvaluationOptions& options,
                                 const std::optional<LabeledView>& view)
    : truth_(truth),
      masks_(transfer_masks(scene.cloud, truth, cloud, static_cast<float>(options.mask_radius))),
      neighbors_(radius_neighbors(cloud.positions, static_cast<float>(options.boundary_radius))),
      view_(view),
      point_count_(cloud.size()) {
  if (view)
    pixel_points_ = PointsInView(cloud, scene.table, options.labels)
                        .points_of(view->camera, view->depth, Eigen::Isometry3d::Identity());
}

SettingCounts CountingContext::count(const std::vector<PointIndices>& found,
                                     const std::vector<RotationAxis>& axes,
                                     const std::vector<ReflectionPlane>& planes) const {
  SettingCounts counts = count_symmetries(truth_, axes, planes);
  const OverlapMatrix overlaps = overlap_matrix(masks_, found);
  for (std::size_t k = 0; k < mask_overlaps.size(); ++k)
    counts.counts[k] = mask_detections(overlaps, mask_overlaps[k]);
  for (const double best : best_overlaps(overlaps)) counts.overlap_sum += best;
  // Added, not assigned, as a sum leaves out the boundaries of scenes without any.
  counts.points += segmentation_metrics(masks_, found, neighbors_);
  return counts;
}

SettingCounts CountingContext::count(const std::vector<SceneObject>& objects) const {
  return count(masks_of(objects), all_axes(objects), all_planes(objects));
}

void CountingContext::count_pixels(const std::vector<PointIndices>& found,
                                   SettingCounts& counts) const {
  if (!view_) return;
  counts.images = 1;
  counts.pixels += pixel_metrics(view_->labels, label_image(pixel_points_, found, point_count_),
                                 view_->camera.width, view_->camera.height);
}

SettingCounts CountingContext::count_with_pixels(const std::vector<SceneObject>& objects) const {
  SettingCounts counts = count(objects);
  count_pixels(masks_of(objects), counts);
  return counts;
}

SettingCounts CountingContext::recount(SettingCounts counts,
                                       const std::vector<SceneObject>& objects) const {
  const SettingCounts own = count_symmetries(truth_, all_axes(objects), all_planes(objects));
  for (const Metric metric : {Metric::axes, Metric::axes_near, Metric::planes, Metric::planes_near})
    counts.detections(metric) = own.detections(metric);
  return counts;
}

SettingCounts count_result(const Scene& scene, const SceneTruth& truth,
                           const SegmentationResult& result, const EvaluationOptions& options) {
  return CountingContext(scene, truth, result.cloud, options).count(result.objects);
}

}  // namespace symscene
