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
          object_score,
          models.object_alone,
          models.object_among_others};
}

SymmetrySearchOptions PipelineOptions::symmetry_search_options() const {
  return {rotational_stream, rotational_detection, reflectional_detection,
          object_symmetry,   models.axis,          models.plane};
}

}  // namespace symscene
