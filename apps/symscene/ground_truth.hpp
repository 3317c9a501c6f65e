#pragma once

#include "facts.hpp"
#include "scene_output.hpp"
#include "symscene/viewer/page.hpp"

namespace symscene::app {

// Ground truth belongs to the evaluation's wing: a build without the simulation leaves it out.

/// The text of truth.json of a scene: the ground truth of the input folder, transferred to the
/// frame and points of the scene. Empty if the input has none. A build that leaves ground truth out
/// warns instead.
std::string transferred_truth(const std::filesystem::path& input, const PosesAndTruth& known,
                              const PointCloud& cloud, Session& session);

/// The ground truth of a scene folder on the cloud of a result of it, for the page; empty if the
/// folder has none, or in a build that leaves ground truth out.
std::vector<PageTruth> page_truth(const std::filesystem::path& scene, const PointCloud& cloud);

/// Adds the ground truth of a scene folder, if it has one. A build that leaves ground truth out
/// adds that the file exists.
void add_ground_truth(Facts& facts, const std::filesystem::path& scene, Index cloud_size);

}  // namespace symscene::app
