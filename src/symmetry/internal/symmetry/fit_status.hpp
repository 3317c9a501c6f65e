#pragma once

namespace symscene {

/// How an iterative fit ended.
enum class FitStatus { converged, iteration_limit, too_few_points, degenerate };

/// Whether the result of a fit can replace its initial value.
inline bool is_usable(FitStatus status) {
  return status == FitStatus::converged || status == FitStatus::iteration_limit;
}

}  // namespace symscene
