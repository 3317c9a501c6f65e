#include "finite_group.hpp"

#include <algorithm>

#include "core/nearest_orthogonal.hpp"

namespace symscene {
namespace {

/// Elements are equal up to this distance (Frobenius), a turn by 8 degrees: those of groups with
/// axes of order up to 12 are at least 30 degrees apart.
constexpr double same = 0.2;

}  // namespace

std::size_t FiniteGroup::index_of(const Eigen::Matrix3d& element) const {
  const auto found = std::find_if(elements_.begin(), elements_.end(), [&](const auto& other) {
    return (other - element).norm() < same;
  });
  return static_cast<std::size_t>(found - elements_.begin());
}

bool FiniteGroup::holds(const Eigen::Matrix3d& element) const {
  return index_of(element) < elements_.size();
}

FiniteGroup FiniteGroup::with(const Eigen::Matrix3d& element, std::size_t max_size) const {
  FiniteGroup group = *this;
  if (group.holds(element)) return group;
  group.elements_.push_back(element);
  // Products of all pairs, also of those that are found on the way.
  for (std::size_t a = 0; a < group.elements_.size(); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      for (const Eigen::Matrix3d& product :
           {Eigen::Matrix3d(group.elements_[a] * group.elements_[b]),
            Eigen::Matrix3d(group.elements_[b] * group.elements_[a])}) {
        if (!group.holds(product)) group.elements_.push_back(product);
        if (group.elements_.size() > max_size) return group;
      }
    }
  }
  return group;
}

FiniteGroup FiniteGroup::exact() const {
  constexpr int rounds = 6;  // the error is squared in each
  FiniteGroup group = *this;
  const std::size_t size = elements_.size();
  std::vector<std::size_t> product(size * size);
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = 0; b < size; ++b)
      product[a * size + b] = index_of(elements_[a] * elements_[b]);
  }
  if (std::find(product.begin(), product.end(), size) != product.end()) return group;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Eigen::Matrix3d> last = group.elements_;
    for (std::size_t a = 0; a < size; ++a) {
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (std::size_t b = 0; b < size; ++b)
        sum += last[product[a * size + b]] * last[b].transpose();
      group.elements_[a] = nearest_orthogonal(sum);
    }
  }
  return group;
}

}  // namespace symscene
