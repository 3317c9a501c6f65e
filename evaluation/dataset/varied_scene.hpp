#pragma once

#include "symscene/dataset/scene_variation.hpp"

namespace symscene {

/// Draws the plan of the scene with that seed. `plan` holds what all scenes have in common, and is
/// returned if variation is not enabled. Throws InputError if an option is out of range.
ScenePlan vary_scene(const SceneVariationOptions& options, ScenePlan plan, std::uint64_t seed);

/// Makes the plan suit the objects: they stand on the table, and the camera keeps its clearance.
void fit_to_objects(const SceneVariationOptions& options, Tabletop& tabletop, ScenePlan& plan);

}  // namespace symscene
