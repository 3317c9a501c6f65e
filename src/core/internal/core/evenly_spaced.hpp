#pragma once

#include <vector>

namespace symscene {

/// The values from `min` to `max` in steps of `step`, both ends included. Throws InputError unless
/// step > 0 and min <= max.
std::vector<double> evenly_spaced(double min, double max, double step);

}  // namespace symscene
