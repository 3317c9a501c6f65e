#pragma once

#include "symscene/evaluation/evaluation.hpp"

namespace symscene {

/// The F of a method in the same scenes as the first one's, and how certain the difference is.
struct MethodDifference {
  std::string method;
  std::string setting;      ///< "default", or its best one in hindsight
  double f = 0.0;           ///< of masks with IoU > 0.9
  double difference = 0.0;  ///< F of the first method at its default minus this F
  /// 95 % of the differences over scenes drawn anew with replacement, the same scenes for both
  /// methods, lie between these (percentile bootstrap, Efron 1979).
  double low = 0.0;
  double high = 0.0;
};

/// The first method that has a default, compared with each other one; empty with fewer than two
/// scenes. The same for equal input: scenes are drawn with a fixed seed.
std::vector<MethodDifference> paired_differences(const Evaluation& evaluation);

/// The name of the method that the others are compared with; empty if none has a default.
std::string compared_method(const Evaluation& evaluation);

}  // namespace symscene
