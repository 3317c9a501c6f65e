#pragma once

#include "symscene/core/scene.hpp"
#include "symscene/pipeline/pipeline_options.hpp"
#include "symscene/proposals/proposals.hpp"

namespace symscene {

/// The objects of a scene (section 4.4): detects rotational symmetries and cuts their objects out,
/// then reflectional ones among the points that are left, chooses objects among the hypotheses of
/// both streams and the parts of the surface, and completes them. World frame, metres. `on_begin`
/// is called with the name of each stage as it begins. Apart from the times, the result has the
/// same bits for any number of threads. `warnings` begin with the scene's own. Throws InputError if
/// the cloud has no finite point, spans more space than memory holds, or an option is invalid.
SegmentationResult segment_scene(const Scene& scene, const PipelineOptions& options = {},
                                 const StageTimer::OnBegin& on_begin = {});

/// The first half of segment_scene(): the hypotheses of both streams (section 4.4) before the
/// bounds of section 4.3.3, and the proposals made of them and of the parts of the surface, with
/// features and scores. The bounds and `min_removal_confidence` still decide which rotational
/// objects are removed before the reflectional stream. Throws InputError as segment_scene() does.
SceneProposals propose_objects(const Scene& scene, const PipelineOptions& options = {},
                               const StageTimer::OnBegin& on_begin = {});

/// The second half of segment_scene(), without completion: chooses objects among the proposals.
/// With `selection.by_score` by their probability (select_probable()), and the symmetries of each
/// object are estimated anew on all its points. Otherwise as in section 4.3.3: hypotheses of both
/// streams within the bounds, equal ones merged (select_consistent()).
SegmentationResult choose_objects(const SceneProposals& proposals,
                                  const PipelineOptions& options = {});

}  // namespace symscene
