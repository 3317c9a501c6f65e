#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace symscene {

/// Parses costs of candidate views: numbers from 0 to 1e9 between white space, or "inf" for a view
/// that cannot be reached. Throws InputError, with the name of the file, at any other word.
std::vector<double> parse_view_costs(std::string_view text, const std::string& name);

}  // namespace symscene
