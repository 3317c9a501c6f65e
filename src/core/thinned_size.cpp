#include "core/thinned_size.hpp"

#include <array>
#include <cmath>
#include <set>

namespace symscene {

std::size_t thinned_size(const Points& points, const PointIndices& indices) {
  constexpr float edge = 0.005F;
  std::set<std::array<int, 3>> cells;
  for (const Index i : indices) {
    const auto cell = [&](int axis) {
      return static_cast<int>(std::floor(points(i, axis) / edge));
    };
    cells.insert({cell(0), cell(1), cell(2)});
  }
  return cells.size();
}

}  // namespace symscene
