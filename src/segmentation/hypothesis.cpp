#include "symscene/segmentation/hypothesis.hpp"

#include <algorithm>
#include <cmath>

namespace symscene {
namespace {

/// 1 for a residual of 0, falling to 0 at the bound.
double margin(double residual, double bound) {
  return bound > 0.0 ? std::clamp(1.0 - residual / bound, 0.0, 1.0) : 0.0;
}

}  // namespace

std::optional<Rejection> judge(const Hypothesis& hypothesis, const HypothesisBounds& bounds,
                               const std::string& kind) {
  const std::size_t size = hypothesis.points.size();
  const HypothesisResiduals& residuals = hypothesis.residuals;
  const auto rejection = [&](const char* reason, double value, double bound) {
    return Rejection{kind, reason, value, bound, size, hypothesis.points};
  };
  if (size < static_cast<std::size_t>(bounds.min_size))
    return rejection("size", static_cast<double>(size), static_cast<double>(bounds.min_size));
  if (residuals.symmetry >= bounds.max_symmetry)
    return rejection("symmetry", residuals.symmetry, bounds.max_symmetry);
  if (residuals.occlusion >= bounds.max_occlusion)
    return rejection("occlusion", residuals.occlusion, bounds.max_occlusion);
  if (residuals.smoothness >= bounds.max_smoothness)
    return rejection("smoothness", residuals.smoothness, bounds.max_smoothness);
  return std::nullopt;
}

double confidence(const HypothesisResiduals& residuals, const HypothesisBounds& bounds) {
  return std::cbrt(margin(residuals.symmetry, bounds.max_symmetry) *
                   margin(residuals.occlusion, bounds.max_occlusion) *
                   margin(residuals.smoothness, bounds.max_smoothness));
}

}  // namespace symscene
