#pragma once

#include <string>
#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// The masks of a baseline in one cloud over a range of its parameter, as table 4.2 compares them.
struct BaselineSweep {
  std::string method;
  std::string parameter;                         ///< the option of the method that is varied
  std::vector<double> values;                    ///< its values [SI units]
  std::vector<std::vector<PointIndices>> masks;  ///< one list per value, largest first
  double seconds = 0.0;  ///< wall time of a run at one value [s]; 0 if not measured
};

}  // namespace symscene
