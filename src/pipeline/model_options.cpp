#include "symscene/pipeline/model_options.hpp"

#include "core/model_features.hpp"
#include "proposals/proposal_context.hpp"
#include "symmetry/axis_features.hpp"
#include "symmetry/plane_features.hpp"
#include "symscene/proposals/object_features.hpp"

namespace symscene {

void ModelOptions::validate() const {
  check_choice<ObjectFeatures>(object_alone, "object_alone");
  check_choice<ObjectFeatures, ProposalContext>(object_among_others, "object_among_others");
  check_choice<AxisFeatures>(axis, "axis");
  check_choice<PlaneFeatures>(plane, "plane");
  if ((object_alone.model == nullptr) != (object_among_others.model == nullptr))
    throw InputError("models", "object_alone and object_among_others of one fit", "only one");
}

}  // namespace symscene
