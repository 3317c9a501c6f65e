#pragma once

#include <string>
#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// What a method of others makes of one cloud over a range of its parameter, as table 4.2 compares
/// them.
struct BaselineSweep {
  std::string method;
  std::string parameter;       ///< the field of the method's options that is varied
  std::vector<double> values;  ///< its values [SI units]
  std::vector<std::vector<PointIndices>> segments;  ///< one partition a value, largest first
};

}  // namespace symscene
