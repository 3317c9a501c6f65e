#pragma once

#include <vector>

#include "symscene/pipeline/plane_measures.hpp"
#include "symscene/pipeline/proposals.hpp"

namespace symscene {

/// A plane that may be a mirror of an object.
struct MeasuredPlane {
  ReflectionPlane plane;
  PlaneMeasures measures;
};

/// The axis of an object whose points are known, if it has one: of those under which it was cut out
/// and those that its points propose by themselves, the one that its points fit best.
void find_axes(const SceneProposals& proposals, const PipelineOptions& options,
               SceneObject& object);

/// The distinct planes that an object's points propose, and those under which it was cut out, by
/// rising misfit. Planes that follow from its axis are left out.
std::vector<MeasuredPlane> measured_planes(const SceneProposals& proposals,
                                           const PipelineOptions& options,
                                           const SceneObject& object);

/// The symmetries of an object whose points are known: those under which it was cut out, and what
/// its points propose by themselves, as far as its points agree with them. Planes through an axis
/// follow from it and are left out. `object.rotational` and `object.reflectional` by rising misfit.
void find_symmetries(const SceneProposals& proposals, const PipelineOptions& options,
                     SceneObject& object);

}  // namespace symscene
