#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/ground_truth/scene_truth.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene::bench {

/// The proposals of a scene as samples for the models of the object score.
struct SceneSamples {
  std::uint32_t number = 0;                  ///< the same for all variants of a scene
  std::vector<std::uint32_t> true_sizes;     ///< number of points, one per true object
  std::vector<std::uint32_t> sizes;          ///< number of points, one per proposal
  std::vector<std::vector<float>> features;  ///< ObjectFeatures, one row per proposal
  std::vector<float> overlaps;               ///< IoU, proposals × true objects
  std::vector<std::uint32_t> shared;         ///< number of common points, proposals × proposals

  std::size_t count() const { return sizes.size(); }
  float overlap(std::size_t proposal, std::size_t object) const {
    return overlaps[(proposal * true_sizes.size()) + object];
  }
};

/// The proposals of a scene and their overlap with its ground truth.
SceneSamples object_samples(const Scene& scene, const SceneTruth& truth,
                            const PipelineOptions& options);

/// Writes and reads the samples of a dataset: a cache, readable only by the same build.
void write_samples(const std::filesystem::path& file, const std::vector<SceneSamples>& scenes);
std::vector<SceneSamples> read_samples(const std::filesystem::path& file);

}  // namespace symscene::bench
