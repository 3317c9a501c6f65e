#pragma once

#include <vector>

#include "symscene/symmetry/symmetry_group.hpp"

namespace symscene {

/// Which of the symmetries that a group lists are rejected, by index. Those beyond the ends are
/// accepted.
struct RejectedSymmetries {
  bool sphere = false;
  std::vector<bool> axes, planes;

  bool axis(std::size_t k) const { return k < axes.size() && axes[k]; }
  bool plane(std::size_t k) const { return k < planes.size() && planes[k]; }
};

/// What remains of a group without the rejected symmetries.
struct RemainingGroup {
  SymmetryGroup group;
  /// Accepted symmetries that are left out, by their index in the group before: with the others
  /// they would make a rejected one.
  std::vector<std::size_t> implied_axes, implied_planes;
};

/// The group without the rejected symmetries, closed again. Of a rejected axis of order n only the
/// turns of lower order stay that accepted symmetries generate; it is then listed, last, with that
/// order.
/// Accepted symmetries are taken by ascending residual as long as they make no rejected one. With
/// a continuous axis the plane and the half turns across it stay or go together; without it the
/// half turn goes too, as it stood for those about all lines across.
RemainingGroup without(const SymmetryGroup& group, const RejectedSymmetries& rejected);

}  // namespace symscene
