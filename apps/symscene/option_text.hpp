#pragma once

#include <string>

#include "config.hpp"

namespace symscene::app {

/// "at least 0", "in (0, 1]"; empty for any value.
std::string range_text(const Range& range);

/// A value in degrees, without needless digits.
std::string degrees_text(double radians);

/// Unit and range: "m, above 0", "rad (10 degrees), in [0, 1.5708]"; empty without either.
std::string kind_text(const OptionField& field);

/// The value as a person reads it: "0.005", "0.1745 (10°)", "true".
std::string value_text(const OptionField& field);

}  // namespace symscene::app
