#pragma once

#include <string>
#include <vector>

namespace symscene {

/// Cells by row, of which the first row is the header.
using TextTable = std::vector<std::vector<std::string>>;

/// Columns as wide as need be; the first `left` to the left, the others to the right.
std::string aligned(const TextTable& table, std::size_t left);

/// "73.2" of 0.732.
std::string percent(double share);

/// "12 (40 %)"; "0" of nothing.
std::string count_and_share(std::size_t part, std::size_t whole);

}  // namespace symscene
