#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// A finite group of orthogonal matrices that are known up to small errors.
class FiniteGroup {
 public:
  FiniteGroup() : elements_(1, Eigen::Matrix3d::Identity()) {}

  /// The identity first.
  const std::vector<Eigen::Matrix3d>& elements() const { return elements_; }
  bool holds(const Eigen::Matrix3d& element) const;
  /// The group that this one and an element generate; what it has beyond this one is at the end.
  /// If it has more than `max_size` elements, it is not complete.
  FiniteGroup with(const Eigen::Matrix3d& element, std::size_t max_size) const;
  /// An exact group near this one: each element a becomes the mean of (a b) b⁻¹ over all b, until
  /// the products are exact (Grove, Karcher and Ruh 1974). A set that is no group is returned as it
  /// is.
  FiniteGroup exact() const;

 private:
  std::size_t index_of(const Eigen::Matrix3d& element) const;  ///< the size without such an element

  std::vector<Eigen::Matrix3d> elements_;
};

}  // namespace symscene
