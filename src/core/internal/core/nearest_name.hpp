#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace symscene {

/// The candidate with the least Levenshtein distance to `name`, the first of equals; empty if none
/// is similar: fewer than about half of the letters to change, add or drop.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// The name in quotes, with its nearest candidate if there is one: "hme" (did you mean "home"?).
std::string with_nearest_name(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace symscene
