#include "table_warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/plane_text.hpp"

namespace symscene {
namespace {

std::string text_of(const SupportPlane& support) {
  return fmt::format("{} ({:.2f} m^2)", plane_text(support.plane), support.area);
}

std::string no_table(const std::vector<SupportPlane>& others) {
  std::vector<std::string> planes;
  for (const SupportPlane& other : others) planes.push_back(text_of(other));
  return fmt::format("no table with objects on it is found, so that all that is seen is taken; {}",
                     planes.empty() ? "there is no plane"
                                    : fmt::format("the table can be given (--plane): {}",
                                                  fmt::join(planes, "; ")));
}

}  // namespace

std::vector<std::string> table_warnings(const TableScene& table) {
  const std::vector<SupportPlane>& supports = table.planes.supports;
  if (supports.empty()) return {no_table(table.planes.others)};
  std::vector<std::string> warnings;
  for (std::size_t k = 1; table.planes.status == SupportStatus::several && k < supports.size(); ++k)
    warnings.push_back(
        "another plane also has objects on it, and can be given as the table "
        "(--plane): " +
        text_of(supports[k]));
  if (table.objects.cloud.empty()) warnings.emplace_back("the table is bare: nothing stands on it");
  return warnings;
}

}  // namespace symscene
