#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/occupancy_map.hpp"

namespace symscene {

/// Parses the leaves of an OctoMap tree with log-odds (.ot), depth first. `name` is the name of the
/// file in messages. Throws InputError if the bytes are not an OctoMap file, end early, continue
/// after the tree or nest deeper than 16, if the number of nodes differs from that in the header,
/// or if a log-odds value is not finite.
LogOddsMap parse_log_odds(std::string_view bytes, const std::string& name);
LogOddsMap read_log_odds(const std::filesystem::path& path);

/// An OctoMap tree with these leaves, which may be in any order; inner nodes get the greatest
/// log-odds of their children. Throws InputError as format_octomap() does, and if a log-odds is not
/// finite.
std::string format_log_odds(const LogOddsMap& map);

/// Writes format_log_odds() atomically.
void write_log_odds(const std::filesystem::path& path, const LogOddsMap& map);

}  // namespace symscene
