#include "symscene/core/options.hpp"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

bool is_bound(double value) {
  return value > std::numeric_limits<double>::lowest() &&
         value < std::numeric_limits<double>::max();
}

/// The least and the greatest magnitude that a number of a unit can have in earnest. A range
/// without an end has that of its unit, so that no number makes a run endless or overflows.
struct UnitBounds {
  std::string_view unit;
  double least, most;
};
constexpr std::array unit_bounds{
    UnitBounds{"m", 1e-9, 1e3},    UnitBounds{"m^2", 1e-12, 1e6},  UnitBounds{"m/s", 1e-9, 1e3},
    UnitBounds{"rad", 1e-9, 7.0},  UnitBounds{"px", 1e-3, 1e5},    UnitBounds{"s", 1e-9, 1e6},
    UnitBounds{"Hz", 1e-6, 1e6},   UnitBounds{"1/s", 1e-6, 1e6},   UnitBounds{"N", 1e-12, 1e15},
    UnitBounds{"N/m", 1e-9, 1e15}, UnitBounds{"1/m", 1e-12, 1e12}, UnitBounds{"1/m²", 1e-12, 1e12},
    UnitBounds{"points", 1.0, 1e9}};
constexpr UnitBounds other_unit{"", 1e-12, 1e7};

const UnitBounds& bounds_of(std::string_view unit) {
  for (const UnitBounds& bounds : unit_bounds) {
    if (bounds.unit == unit) return bounds;
  }
  return other_unit;
}

bool is_seed(const Range& range, std::string_view unit) {
  return unit.empty() && !is_bound(range.low) && !is_bound(range.high);
}

/// The range with ends where it has none.
Range bounded(Range range, const UnitBounds& bounds) {
  if (!is_bound(range.low)) range.low = -bounds.most;
  if (!is_bound(range.high)) range.high = bounds.most;
  if (range.excludes_low && range.low == 0.0) {
    range.low = bounds.least;
    range.excludes_low = false;
  }
  return range;
}

[[noreturn]] void refuse(const char* option, double value, const char* unit, const Range& range) {
  std::string expected = "a number";
  if (const std::string bounds = to_string(range); !bounds.empty()) expected += " " + bounds;
  if (*unit != '\0') expected += fmt::format(" {}", unit);
  throw InputError(option, expected, fmt::format("{:g}", value));
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
  if (!range.contains(value)) refuse(option, value, unit, range);
  const Range ends = bounded(range, bounds_of(unit));
  if (!is_seed(range, unit) && !ends.contains(value)) refuse(option, value, unit, ends);
}

}  // namespace symscene
