#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/occupancy_map.hpp"

namespace symscene {

/// The leaves of an OctoMap tree with log-odds (.ot), depth first. `name` stands for the file in
/// messages. Throws InputError if the bytes are no such file, end early or go on after the tree,
/// nest deeper than 16, hold another number of nodes than their header says, or a log-odds that is
/// not finite.
LogOddsMap parse_log_odds(std::string_view bytes, const std::string& name);
LogOddsMap read_log_odds(const std::filesystem::path& path);

/// An OctoMap tree with these leaves, which may come in any order; inner nodes have the greatest
/// log-odds below them. Throws InputError as format_octomap() does, and if a log-odds is not
/// finite.
std::string format_log_odds(const LogOddsMap& map);

/// Writes format_log_odds() atomically.
void write_log_odds(const std::filesystem::path& path, const LogOddsMap& map);

}  // namespace symscene
