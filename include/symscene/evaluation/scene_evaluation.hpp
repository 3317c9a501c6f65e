#pragma once

#include <functional>

#include "symscene/evaluation/losses.hpp"
#include "symscene/evaluation/sweep.hpp"

namespace symscene {

/// Another method's masks of a scene, for each value of its parameter; by falling confidence where
/// it has one.
struct PeerMasks {
  std::string method;
  std::string parameter;
  std::vector<double> values;
  std::vector<std::vector<PointIndices>> masks;  ///< into the cloud given, a list a value
};
using PeerMethod = std::function<PeerMasks(const PointCloud&)>;

struct EvaluationOptions {
  PipelineOptions pipeline;       ///< as the command has them; the sweeps vary its bounds
  std::vector<PeerMethod> peers;  ///< run on the 5 mm cloud of each scene
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
  std::vector<Sweep> segmentation;  ///< the pipeline's variants, then the peers, in fixed order
  std::vector<Sweep> detection;     ///< rotational and reflectional, before segmentation
  std::vector<ObjectOutcome> objects;
  std::vector<StageTime> timings;  ///< of segmentation at the given options, without completion
  std::size_t returned = 0;        ///< objects that it returned
};

/// Names of the methods in `segmentation` and `detection`. The second of `segmentation` is the
/// first with its name and ", by score".
inline constexpr const char* full_method = "Rot + Refl";
inline constexpr const char* reflectional_method = "Refl only";
inline constexpr const char* axis_detection_method = "Axes before segmentation";
inline constexpr const char* plane_detection_method = "Planes before segmentation";

/// Throws InputError, naming the object, if a truth is missing (an object without points) or
/// contradicts itself or the cloud (an index that the cloud does not have, a point of two objects).
void require_usable_truth(const Scene& scene, const SceneTruth& truth);

/// What one result counts for. Throws InputError as transfer_masks() does.
SettingCounts count_result(const Scene& scene, const SceneTruth& truth,
                           const SegmentationResult& result, const EvaluationOptions& options = {});

/// Segments and scores are computed once, thresholds are swept over them: the bounds of table 4.2
/// on the segments of the pipeline and of its variant without rotations, the bounds of table 3.1 on
/// the symmetries before segmentation, and the least score on what the given options return. A
/// candidate symmetry that equals another is merged before the sweep, not at each of its bounds.
/// Equal for any number of threads but for the times, which are wall times. Throws InputError as
/// require_usable_truth() and segment_scene() do.
SceneEvaluation evaluate_scene(const Scene& scene, const SceneTruth& truth,
                               const EvaluationOptions& options = {},
                               const StageTimer::OnBegin& on_begin = {});

}  // namespace symscene
