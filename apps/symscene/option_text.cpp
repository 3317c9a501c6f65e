#include "option_text.hpp"

#include <numbers>
#include <type_traits>

#include <fmt/format.h>

namespace symscene::app {

std::string range_text(const Range& range) {
  const std::string text = to_string(range);
  return text.starts_with("of ") ? text.substr(3) : text;
}

std::string degrees_text(double radians) {
  return fmt::format("{:.4g}", radians * 180.0 / std::numbers::pi);
}

std::string kind_text(const OptionField& field) {
  std::string text = field.unit;
  const auto* const* value = std::get_if<double*>(&field.value);
  if (field.unit == "rad" && value != nullptr)
    text += fmt::format(" ({} degrees)", degrees_text(**value));
  const std::string range = range_text(field.range);
  if (!text.empty() && !range.empty()) text += ", ";
  return text + range;
}

std::string value_text(const OptionField& field) {
  return std::visit(
      [&](const auto* value) {
        if constexpr (std::is_same_v<decltype(value), const std::string*>)
          return fmt::format("\"{}\"", *value);
        if constexpr (std::is_same_v<decltype(value), const double*>) {
          if (field.unit == "rad") return fmt::format("{:.4g} ({}°)", *value, degrees_text(*value));
        }
        return fmt::format("{}", *value);
      },
      field.value);
}

}  // namespace symscene::app
