#include "core/nearest_name.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace symscene {
namespace {

/// Levenshtein distance: letters to change, add or drop between two words.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t least = name.size() / 2 + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(candidate, name);
    if (distance >= least) continue;
    best = candidate;
    least = distance;
  }
  return best;
}

std::string with_nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string best = nearest_name(name, candidates);
  if (best.empty()) return fmt::format("\"{}\"", name);
  return fmt::format("\"{}\" (did you mean \"{}\"?)", name, best);
}

}  // namespace symscene
