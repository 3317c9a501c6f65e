#pragma once

#include <vector>

#include "symscene/core/point_cloud.hpp"
#include "symscene/ground_truth/scene_truth.hpp"

namespace symscene {

/// Transfers the masks of `truth`, indices into `labeled`, to another cloud of the same scene, such
/// as the thinned cloud of a result: each point of `target` takes the label of the nearest point of
/// `labeled` within `radius` [m]. Throws InputError if a mask names a point that `labeled` does not
/// have.
std::vector<PointIndices> transfer_masks(const PointCloud& labeled, const SceneTruth& truth,
                                         const PointCloud& target, float radius = 0.01F);

}  // namespace symscene
