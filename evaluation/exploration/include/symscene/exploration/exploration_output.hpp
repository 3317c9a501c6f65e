#pragma once

#include <string>
#include <vector>

#include "symscene/exploration/table_exploration.hpp"
#include "symscene/viewer/exploration_page.hpp"

// What `symscene explore` writes and prints of an exploration.
namespace symscene {

/// The text of exploration.json (docs/formats.md). `description` is JSON that tells what made it.
/// Equal explorations give equal bytes apart from the times. Throws nlohmann::json's exceptions if
/// the description is not JSON.
std::string format_exploration_json(const TableExploration& exploration, const Tabletop& table,
                                    const std::string& description);

/// Why no further view was taken: a phrase.
const char* description(ExplorationEnd end);

/// "cm²" or "voxels": in which gains of the policy are told to people.
const char* gain_unit(ExplorationPolicy policy);
/// A gain, in m² or voxels, in that unit.
double shown_gain(double gain, ExplorationPolicy policy);

/// "view 3 from candidate 17: gain 41.2 cm², 5 objects, observed 0.71, completed 0.93".
std::string format_explored_view(const ExploredView& view, std::size_t number,
                                 ExplorationPolicy policy);

/// What is left unknown, one sentence each: the surface that is inferred, of all objects and of
/// each of which much is, the border of unknown space, the best view that was not taken, and true
/// objects of which little was seen.
std::vector<std::string> format_left_unknown(const TableExploration& exploration,
                                             const Tabletop& table);

/// The exploration as the page plays it: each view takes a moment, the camera moves between.
ExplorationRecording exploration_recording(const TableExploration& exploration,
                                           const Tabletop& table);

}  // namespace symscene
