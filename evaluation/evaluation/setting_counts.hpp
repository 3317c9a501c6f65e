#pragma once

#include "symscene/evaluation/scene_evaluation.hpp"

namespace symscene {

/// The counts of the symmetry metrics of a setting; empty if no symmetries are known.
SettingCounts count_symmetries(const SceneTruth& truth, const std::vector<RotationAxis>& axes,
                               const std::vector<ReflectionPlane>& planes);

/// What the counts of all settings in one scene have in common: the true masks in the cloud of the
/// found masks, and the neighbours in that cloud.
class CountingContext {
 public:
  /// The referents of `view` must outlive the context.
  CountingContext(const Scene& scene, const SceneTruth& truth, const PointCloud& cloud,
                  const EvaluationOptions& options,
                  const std::optional<LabeledView>& view = std::nullopt);

  const std::vector<PointIndices>& masks() const { return masks_; }

  /// `found` has the masks by descending confidence.
  SettingCounts count(const std::vector<PointIndices>& found, const std::vector<RotationAxis>& axes,
                      const std::vector<ReflectionPlane>& planes) const;
  SettingCounts count(const std::vector<SceneObject>& objects) const;

  /// Adds the metrics of the masks on the label image, if the scene has one.
  void count_pixels(const std::vector<PointIndices>& found, SettingCounts& counts) const;
  SettingCounts count_with_pixels(const std::vector<SceneObject>& objects) const;

  /// The counts of the same masks with other symmetries.
  SettingCounts recount(SettingCounts counts, const std::vector<SceneObject>& objects) const;

 private:
  const SceneTruth& truth_;
  std::vector<PointIndices> masks_;
  NeighborLists neighbors_;
  std::optional<LabeledView> view_;
  std::size_t point_count_;
  std::vector<Index> pixel_points_;  ///< per pixel of the view the point of the cloud, if any
};

}  // namespace symscene
