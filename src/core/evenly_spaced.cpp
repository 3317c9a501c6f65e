#include "core/evenly_spaced.hpp"

#include <cmath>

#include "symscene/core/error.hpp"

namespace symscene {

std::vector<double> evenly_spaced(double min, double max, double step) {
  require_option(step > 0.0 && min <= max, "step", "a step above 0 from min up to max", step);
  std::vector<double> values;
  const auto count = static_cast<int>(std::floor((max - min) / step + 1e-6));
  // Rounded to what the tables print, so that 0.1 in steps of 0.1 holds 0.3 itself.
  for (int k = 0; k <= count; ++k) values.push_back(std::round((min + k * step) * 1e9) / 1e9);
  return values;
}

}  // namespace symscene
