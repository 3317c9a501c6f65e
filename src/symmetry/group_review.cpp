#include "symscene/symmetry/group_review.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "finite_group.hpp"
#include "motion_fit.hpp"

namespace symscene {
namespace {

/// A listed symmetry by its index, and the motions that it stands for about the centre.
struct Listed {
  bool is_axis;
  std::size_t index;
  double residual;
  std::vector<Eigen::Matrix3d> elements;  ///< that generate it
};

/// The rotation by k turns of an axis' order.
Eigen::Matrix3d turn(const GroupAxis& found, int k) {
  return found.axis.rotation(2.0 * std::numbers::pi * k / found.order);
}

/// The turns that make an axis one of its order: without the half turn of a 4-fold axis.
std::vector<Eigen::Matrix3d> turns_of(const GroupAxis& found) {
  std::vector<Eigen::Matrix3d> turns;
  for (int k = 1; k < found.order; ++k) {
    if (std::gcd(k, found.order) == 1) turns.push_back(turn(found, k));
  }
  return turns;
}

std::vector<Listed> listed_symmetries(const SymmetryGroup& group) {
  std::vector<Listed> listed;
  for (std::size_t k = 0; k < group.axes.size(); ++k)
    listed.push_back({true, k, group.axes[k].residual, turns_of(group.axes[k])});
  for (std::size_t k = 0; k < group.planes.size(); ++k)
    listed.push_back(
        {false, k, group.planes[k].residual, {motion_of(group.planes[k].plane).linear()}});
  std::stable_sort(listed.begin(), listed.end(),
                   [](const Listed& a, const Listed& b) { return a.residual < b.residual; });
  return listed;
}

bool is_rejected(const Listed& each, const RejectedSymmetries& rejected) {
  return each.is_axis ? rejected.axis(each.index) : rejected.plane(each.index);
}

/// Whether all proper rotations of a finite group are among those of the whole group.
bool is_part_of(const FiniteGroup& finite, const FiniteGroup& whole) {
  return std::all_of(finite.elements().begin(), finite.elements().end(),
                     [&](const Eigen::Matrix3d& element) {
                       return element.determinant() < 0.0 || whole.holds(element);
                     });
}

FiniteGroup rotations_of(const SymmetryGroup& group) {
  constexpr std::size_t most = 120;
  FiniteGroup rotations;
  for (const Eigen::Isometry3d& rotation : group.rotations)
    rotations = rotations.with(rotation.linear(), most);
  return rotations;
}

void set_rotations(SymmetryGroup& group, const FiniteGroup& finite) {
  group.rotations.clear();
  const FiniteGroup exact = finite.exact();
  for (const Eigen::Matrix3d& element : exact.elements()) {
    if (element.determinant() < 0.0 || element.trace() > 2.999) continue;
    Eigen::Isometry3d rotation = Eigen::Isometry3d::Identity();
    rotation.linear() = element;
    rotation.translation() = group.center - element * group.center;
    group.rotations.push_back(rotation);
  }
}

/// The group while accepted symmetries are added to it.
class Remainder {
 public:
  Remainder(const SymmetryGroup& group, const RejectedSymmetries& rejected)
      : group_(group), rotations_(rotations_of(group)) {
    remaining_.group = group;
    remaining_.group.axes.clear();
    remaining_.group.planes.clear();
    const std::vector<Listed> listed = listed_symmetries(group);
    for (const Listed& each : listed) {
      if (!is_rejected(each, rejected)) continue;
      if (each.is_axis) rejected_axes_.push_back(each.index);
      forbidden_.insert(forbidden_.end(), each.elements.begin(), each.elements.end());
    }
    for (const Listed& each : listed) {
      if (!is_rejected(each, rejected)) add(each);
    }
  }

  RemainingGroup finish() {
    // In the order of the group before.
    const auto keep = [](const auto& all, std::vector<std::size_t>& kept, auto& list) {
      std::sort(kept.begin(), kept.end());
      for (const std::size_t k : kept) list.push_back(all[k]);
    };
    keep(group_.axes, kept_axes_, remaining_.group.axes);
    keep(group_.planes, kept_planes_, remaining_.group.planes);
    for (const std::size_t k : rejected_axes_) keep_lower_order(group_.axes[k]);
    set_rotations(remaining_.group, finite_);
    return std::move(remaining_);
  }

 private:
  /// Lists a rejected axis with the order that accepted symmetries still give it.
  void keep_lower_order(GroupAxis axis) {
    for (int k = 2; k < axis.order; ++k) {
      if (axis.order % k != 0 || !finite_.holds(turn(axis, k))) continue;
      axis.order /= k;
      remaining_.group.axes.push_back(axis);
      return;
    }
  }

  void add(const Listed& each) {
    constexpr std::size_t most = 120;
    const FiniteGroup larger = finite_.with(each.elements.front(), most);
    if (makes_forbidden(larger)) {
      (each.is_axis ? remaining_.implied_axes : remaining_.implied_planes).push_back(each.index);
      return;
    }
    (each.is_axis ? kept_axes_ : kept_planes_).push_back(each.index);
    // Some listed axes generate no group of symmetries; they are not among the rotations.
    if (is_part_of(larger, rotations_)) finite_ = larger;
  }
  bool makes_forbidden(const FiniteGroup& finite) const {
    return std::any_of(forbidden_.begin(), forbidden_.end(),
                       [&](const Eigen::Matrix3d& element) { return finite.holds(element); });
  }

  const SymmetryGroup& group_;
  FiniteGroup rotations_, finite_;
  std::vector<Eigen::Matrix3d> forbidden_;
  std::vector<std::size_t> rejected_axes_, kept_axes_, kept_planes_;
  RemainingGroup remaining_;
};

/// Of a surface of revolution: the axis first, a half turn and a plane across it.
RemainingGroup without_of_revolution(const SymmetryGroup& group,
                                     const RejectedSymmetries& rejected) {
  RemainingGroup remaining{group, {}, {}};
  remaining.group.axes.clear();
  remaining.group.planes.clear();
  remaining.group.rotations.clear();
  const bool turns = !rejected.axis(0);
  if (turns) remaining.group.axes.push_back(group.axes.front());
  bool is_whole = true;
  for (std::size_t k = 1; k < group.axes.size(); ++k) is_whole = is_whole && !rejected.axis(k);
  for (std::size_t k = 0; k < group.planes.size(); ++k) is_whole = is_whole && !rejected.plane(k);
  if (turns && is_whole) return {group, {}, {}};
  for (std::size_t k = 1; k < group.axes.size(); ++k) {
    if (!rejected.axis(k)) remaining.implied_axes.push_back(k);
  }
  for (std::size_t k = 0; k < group.planes.size(); ++k) {
    if (rejected.plane(k)) continue;
    if (turns) {
      remaining.implied_planes.push_back(k);
    } else {
      remaining.group.planes.push_back(group.planes[k]);
    }
  }
  return remaining;
}

}  // namespace

RemainingGroup without(const SymmetryGroup& group, const RejectedSymmetries& rejected) {
  if (group.sphere) {
    RemainingGroup remaining{group, {}, {}};
    remaining.group.sphere = !rejected.sphere;
    return remaining;
  }
  if (!group.axes.empty() && group.axes.front().order == GroupAxis::continuous)
    return without_of_revolution(group, rejected);
  return Remainder(group, rejected).finish();
}

}  // namespace symscene
