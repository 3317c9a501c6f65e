#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symscene/simulation/object_model.hpp"

namespace symscene {

/// What scenes are used for: to fit parameters and learned scores (training) or to report accuracy
/// (test). The splits share neither seeds nor models.
enum class Split : std::uint8_t { training, test };

const char* to_string(Split split);

/// Reads "training" or "test"; "tune" and "report" too, as datasets made earlier name them. Throws
/// InputError naming `where` for any other text.
Split parse_split(const std::string& text, const std::string& where);

/// The seed of a scene, below 2^53 so that every JSON reader represents it exactly. The splits have
/// no seed in common. `attempt` counts the seeds of a scene from 0.
std::uint64_t scene_seed(std::uint64_t dataset_seed, Split split, std::size_t index,
                         std::size_t attempt = 0);

/// The number of objects of a scene: among any number of scenes from the first on, each count from
/// `min_objects` to `max_objects` occurs equally often, to within one.
int object_count(std::uint64_t dataset_seed, Split split, std::size_t index, int min_objects,
                 int max_objects);

/// The models of a split: families, in the order of their names, go to the training and the test
/// split in turn. A family is the models whose names are equal up to the first '-'.
std::vector<ObjectModel> models_of(Split split, std::vector<ObjectModel> models);

}  // namespace symscene
