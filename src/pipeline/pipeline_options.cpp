#include "symscene/pipeline/pipeline_options.hpp"

namespace symscene {

ProposalOptions PipelineOptions::proposal_options() const {
  return {surface_parts,
          rotational_segmentation.bounds,
          reflectional_segmentation.bounds,
          rotational_detection,
          reflectional_detection,
          continuation,
          merge,
          object_features,
          proposal_context,
          models.object_alone,
          models.object_among_others,
          classes,
          class_segmentation,
          voxel_size};
}

SymmetrySearchOptions PipelineOptions::symmetry_search_options() const {
  SymmetrySearchOptions search{rotational_stream, rotational_detection, reflectional_detection,
                               object_symmetry,   models.axis,          models.plane};
  // On a whole object, points near a plane count as they do in the features of the plane.
  ReflectionalDetectionOptions& planes = search.reflectional_detection;
  for (CorrespondenceOptions* matching : {&planes.fit.matching, &planes.scoring})
    matching->min_plane_distance = object_symmetry.plane_features.min_plane_distance;
  return search;
}

}  // namespace symscene
