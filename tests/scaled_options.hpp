#pragma once

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "symscene/core/options.hpp"

/// Options for a scene that is scaled: what is a length in them is scaled with it.
namespace symscene::testing {

/// The power of metres in the unit of an option. Throws on a unit that is not listed: a new one is
/// added here, so that no length stays as it is unnoticed.
inline int power_of_metres(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, int>, 5> lengths{
      {{"m", 1}, {"m^2", 2}, {"m2", 2}, {"1/m", -1}, {"1/m^2", -2}}};
  constexpr std::array<std::string_view, 10> others{"",    "rad", "points",  "turn",   "edges",
                                                    "IoU", "px",  "patches", "frames", "s"};
  for (const auto& [name, power] : lengths) {
    if (unit == name) return power;
  }
  for (const std::string_view name : others) {
    if (unit == name) return 0;
  }
  throw std::logic_error("an option has the unit '" + std::string(unit) +
                         "', whose power of metres is not known");
}

/// The visitor of scale_lengths().
struct LengthScaling {
  double scale = 1.0;

  template <class Value>
  void operator()(const char* /*name*/, Value& value, const char* unit, const Range& /*range*/,
                  const char* /*help*/) const {
    const int power = power_of_metres(unit);
    if constexpr (std::is_same_v<Value, double>) {
      value *= std::pow(scale, power);
    } else if (power != 0) {
      throw std::logic_error("an option that is a length is no floating-point number");
    }
  }
  template <class Group>
  void operator()(const char* /*name*/, Group& group) const {
    Group::visit_fields(group, *this);
  }
};

/// The options with every field, in nested groups too, multiplied by `scale` to the power of metres
/// in its unit.
template <class Options>
Options scaled_lengths(Options options, double scale) {
  Options::visit_fields(options, LengthScaling{scale});
  return options;
}

}  // namespace symscene::testing
