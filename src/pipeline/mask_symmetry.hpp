#pragma once

#include "symscene/pipeline/proposals.hpp"

namespace symscene {

/// The symmetries of an object whose points are known: those under which it was cut out, and what
/// its points propose by themselves, as far as its points agree with them. Planes through an axis
/// follow from it and are left out. `object.rotational` and `object.reflectional` by rising misfit.
void find_symmetries(const SceneProposals& proposals, const PipelineOptions& options,
                     SceneObject& object);

}  // namespace symscene
