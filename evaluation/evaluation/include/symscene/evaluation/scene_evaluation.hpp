#pragma once

#include <functional>

#include "symscene/evaluation/missed_objects.hpp"
#include "symscene/evaluation/sweep.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene {

/// Another method's masks of a scene, for each value of its parameter; by falling confidence where
/// it has one.
struct BaselineMasks {
  std::string method;
  std::string parameter;
  std::vector<double> values;
  std::vector<std::vector<PointIndices>> masks;  ///< into the cloud given, a list a value
};
using BaselineMethod = std::function<BaselineMasks(const PointCloud&)>;

struct EvaluationOptions {
  PipelineOptions pipeline;               ///< as the command has them; the sweeps vary its bounds
  std::vector<BaselineMethod> baselines;  ///< run on the 5 mm cloud of each scene
  bool reflectional_only = true;  ///< evaluate the pipeline without the rotational stream too
  double boundary_radius = 0.01;  ///< of the neighbours that make a boundary [m]
  double mask_radius = 0.01;      ///< from the truth's points to those of the 5 mm cloud [m]

  /// Throws InputError on a radius that is not positive or an invalid option of the pipeline.
  void validate() const;
};

/// Everything that a report needs of one scene; no clouds, no masks.
struct SceneEvaluation {
  std::string name;
  std::string subset;      ///< of the dataset, may be empty
  std::size_t unseen = 0;  ///< objects of which too little is seen for the truth to ask for them
  std::vector<Sweep> segmentation;  ///< the pipeline's variants, then the baselines, in fixed order
  std::vector<Sweep> detection;     ///< rotational and reflectional, before segmentation
  std::vector<ObjectOutcome> objects;
  std::vector<StageTime> timings;  ///< of segmentation at the given options, without completion
  std::size_t returned = 0;        ///< objects that it returned
};

/// Names of the methods in `segmentation` and `detection`: everything proposed, chosen by score;
/// and the cuts within the bounds of section 4.3.3, with the rotational stream and without.
inline constexpr const char* scored_method = "SymScene";
inline constexpr const char* full_method = "Rot + Refl, bounds";
inline constexpr const char* reflectional_method = "Refl only, bounds";
inline constexpr const char* axis_detection_method = "Axes before segmentation";
inline constexpr const char* plane_detection_method = "Planes before segmentation";

/// Throws InputError, naming the object, if a truth is missing (an object without points) or
/// contradicts itself or the cloud (an index that the cloud does not have, a point of two objects).
void require_usable_truth(const Scene& scene, const SceneTruth& truth);

/// What one result counts for. Throws InputError as transfer_masks() does.
SettingCounts count_result(const Scene& scene, const SceneTruth& truth,
                           const SegmentationResult& result, const EvaluationOptions& options = {});

/// Segments and scores are computed once, thresholds are swept over them: the least
/// probability on everything that is proposed, the bounds of table 4.2 on the cuts of the pipeline
/// and of its variant without rotations, and the bounds of table 3.1 on the symmetries before
/// segmentation. A candidate symmetry that equals another is merged before the sweep, not at each
/// of its bounds. Equal for any number of threads but for the times, which are wall times. Throws
/// InputError as require_usable_truth() and segment_scene() do.
SceneEvaluation evaluate_scene(const Scene& scene, const SceneTruth& truth,
                               const EvaluationOptions& options = {},
                               const StageTimer::OnBegin& on_begin = {});

}  // namespace symscene
