#pragma once

#include <string>
#include <vector>

namespace symscene {

/// Rows of cells; the first row is the header.
using TextTable = std::vector<std::vector<std::string>>;

/// The table with aligned columns: the first `left` flush left, the others flush right.
std::string aligned(const TextTable& table, std::size_t left);

/// "73.2" of 0.732.
std::string percent(double share);

/// "12 (40 %)"; "0" of none.
std::string count_and_share(std::size_t part, std::size_t whole);

}  // namespace symscene
