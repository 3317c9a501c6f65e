#include "core/perpendicular_planes.hpp"

#include <algorithm>
#include <numbers>

namespace symscene {
namespace {

constexpr std::size_t most_planes = 3;  // that can be at right angles to each other

}  // namespace

std::vector<ReflectionPlane> perpendicular_planes(const std::vector<ObjectPlane>& planes,
                                                  double tolerance) {
  std::vector<ReflectionPlane> chosen;
  for (const ObjectPlane& candidate : planes) {
    if (chosen.size() == most_planes) break;
    const bool fits = std::all_of(chosen.begin(), chosen.end(), [&](const ReflectionPlane& other) {
      return line_angle(candidate.plane.normal, other.normal) > std::numbers::pi / 2 - tolerance;
    });
    if (fits) chosen.push_back(candidate.plane);
  }
  return chosen;
}

}  // namespace symscene
