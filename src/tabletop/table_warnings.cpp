#include "table_warnings.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/plane_text.hpp"

namespace symscene {
namespace {

std::string text_of(const SupportPlane& support) {
  return fmt::format("{} ({:.2f} m^2)", plane_text(support.plane), support.area);
}

std::vector<std::string> texts_of(const std::vector<SupportPlane>& supports) {
  std::vector<std::string> texts;
  for (const SupportPlane& support : supports) texts.push_back(text_of(support));
  return texts;
}

std::string no_table(const std::vector<SupportPlane>& others) {
  const std::vector<std::string> planes = texts_of(others);
  return fmt::format("no table with objects on it is found, so that all that is seen is taken; {}",
                     planes.empty() ? "there is no plane"
                                    : fmt::format("the table can be given (--plane): {}",
                                                  fmt::join(planes, "; ")));
}

/// The supports but for the table. Tilted ones are surfaces of objects where a level one is found.
std::vector<SupportPlane> alternatives(const std::vector<SupportPlane>& supports) {
  std::vector<SupportPlane> others(supports.begin() + 1, supports.end());
  const bool any_level =
      std::any_of(supports.begin(), supports.end(), [](const auto& s) { return !s.is_tilted; });
  if (any_level) std::erase_if(others, [](const auto& s) { return s.is_tilted; });
  return others;
}

std::string other_tables(const std::vector<SupportPlane>& others) {
  const char* found = others.size() == 1 ? "another plane also has objects on it"
                                         : "other planes also have objects on them";
  return fmt::format("{}, and can be given as the table (--plane): {}", found,
                     fmt::join(texts_of(others), "; "));
}

}  // namespace

std::vector<std::string> table_warnings(const TableScene& table) {
  const std::vector<SupportPlane>& supports = table.planes.supports;
  if (supports.empty()) return {no_table(table.planes.others)};
  std::vector<std::string> warnings;
  if (table.is_against_up)
    warnings.emplace_back(
        "the camera seems not to have been held upright: the table does not face its upward "
        "direction");
  if (table.planes.status == SupportStatus::several) {
    const std::vector<SupportPlane> others = alternatives(supports);
    if (!others.empty()) warnings.push_back(other_tables(others));
  }
  if (table.objects.cloud.empty())
    warnings.push_back(fmt::format(
        "the table is bare: nothing stands on the plane {}; if something does, it is not the plane "
        "of the table",
        plane_text(supports.front().plane)));
  return warnings;
}

}  // namespace symscene
