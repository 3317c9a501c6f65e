#pragma once

#include <functional>
#include <optional>
#include <span>

#include "symscene/baselines/baseline_sweep.hpp"
#include "symscene/evaluation/missed_objects.hpp"
#include "symscene/evaluation/sweep.hpp"
#include "symscene/labels/label_image.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene {

using BaselineMethod = std::function<BaselineSweep(const PointCloud&)>;

struct EvaluationOptions {
  PipelineOptions pipeline;
  bool reflectional_only = true;
  double boundary_radius = 0.01;
  double mask_radius = 0.01;
  LabelImageOptions labels;
  std::vector<BaselineMethod> baselines;  ///< run on the 5 mm cloud of each scene

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("pipeline", self.pipeline);
    visit(
        "reflectional_only", self.reflectional_only, "", any_value(),
        "evaluate the pipeline without its rotational stream too, by planes of smooth segments and "
        "by planes of curves");
    visit("boundary_radius", self.boundary_radius, "m", strictly_between(0.0, 1.0),
          "distance of a neighbour with another label that makes a point a boundary point");
    visit("mask_radius", self.mask_radius, "m", strictly_between(0.0, 1.0),
          "largest distance over which a mask is transferred to the 5 mm cloud");
    visit("labels", self.labels);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// The only frame of a scene, in whose camera's frame the scene is, with its true labels: 0 is the
/// table or nothing, k is object k.
struct LabeledView {
  const CameraIntrinsics& camera;
  std::span<const float> depth;
  std::span<const std::uint16_t> labels;
};

/// The evaluation of one scene, without clouds and masks.
struct SceneEvaluation {
  std::string name;
  std::string subset;               ///< of the dataset, may be empty
  std::vector<Sweep> segmentation;  ///< the variants of the pipeline, then the baselines
  std::vector<Sweep> detection;     ///< axes, planes, planes of curves, before segmentation
  std::vector<ObjectOutcome> objects;
  std::vector<StageTime> timings;     ///< of segmentation at the given options, without completion
  std::size_t returned = 0;           ///< number of objects that it returned
  std::vector<std::string> warnings;  ///< of reading and of segmentation, one sentence each
};

/// Names of the methods in `segmentation` and `detection`: proposals selected by score, and
/// hypotheses within the bounds of section 4.3.3 with and without the rotational stream, and
/// without it by planes of curves alone (section 3.4).
inline constexpr const char* scored_method = "SymScene";
inline constexpr const char* full_method = "Rot + Refl, bounds";
inline constexpr const char* reflectional_method = "Refl only, bounds";
inline constexpr const char* curve_method = "Refl (curve), bounds";
inline constexpr const char* axis_detection_method = "Axes before segmentation";
inline constexpr const char* plane_detection_method = "Planes before segmentation";
inline constexpr const char* curve_detection_method = "Planes of curves before segmentation";

/// Throws InputError, naming the object, if a mask has an index that the cloud does not have, or
/// two masks share a point.
void require_usable_truth(const Scene& scene, const SceneTruth& truth);

/// The counts of one result. Throws InputError as transfer_masks() does.
SettingCounts count_result(const Scene& scene, const SceneTruth& truth,
                           const SegmentationResult& result, const EvaluationOptions& options = {});

/// Evaluates the pipeline and the baselines in a scene. Proposals and scores are computed once
/// and thresholds are swept over them: the least probability over all proposals, the bounds of
/// table 4.2 over the hypotheses of the pipeline and of its variant without rotations, and the
/// bounds of table 3.1 over the symmetries before segmentation. Equal candidate symmetries are
/// merged before the sweep, not at each of its bounds. All but the wall times is equal for any
/// number of threads. With `view`, the results of the given options and of the baselines are
/// compared with its labels pixel by pixel too. Throws InputError as require_usable_truth() and
/// segment_scene() do.
SceneEvaluation evaluate_scene(const Scene& scene, const SceneTruth& truth,
                               const EvaluationOptions& options = {},
                               const StageTimer::OnBegin& on_begin = {},
                               const std::optional<LabeledView>& view = std::nullopt);

}  // namespace symscene
