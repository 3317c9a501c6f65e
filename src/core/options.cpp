#include "symscene/core/options.hpp"

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

bool is_bound(double value) {
  return value > std::numeric_limits<double>::lowest() &&
         value < std::numeric_limits<double>::max();
}

}  // namespace

std::string to_string(const Range& range) {
  if (is_bound(range.low) && is_bound(range.high)) {
    return fmt::format("in {}{:g}, {:g}{}", range.excludes_low ? '(' : '[', range.low, range.high,
                       range.excludes_high ? ')' : ']');
  }
  if (is_bound(range.low))
    return fmt::format("{} {:g}", range.excludes_low ? "above" : "of at least", range.low);
  if (is_bound(range.high))
    return fmt::format("{} {:g}", range.excludes_high ? "below" : "of at most", range.high);
  return "";
}

void require_in_range(const char* option, double value, const char* unit, const Range& range) {
  if (range.contains(value)) return;
  std::string expected = "a number";
  if (const std::string bounds = to_string(range); !bounds.empty()) expected += " " + bounds;
  if (*unit != '\0') expected += fmt::format(" {}", unit);
  throw InputError(option, expected, fmt::format("{:g}", value));
}

}  // namespace symscene
