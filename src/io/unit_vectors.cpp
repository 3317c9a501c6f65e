#include "unit_vectors.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr double rounding = 1e-12;          ///< tolerance on the length of a unit vector
constexpr double shortest_vector = 1e-290;  ///< below it a quotient has no precision

double length_of(const Eigen::Vector3d& vector, const std::string& where) {
  const double length = vector.stableNorm();
  if (length > shortest_vector && std::isfinite(length)) {
    return std::abs(length - 1.0) <= rounding ? 1.0 : length;
  }
  throw InputError(where, "a direction", "a vector without length");
}

}  // namespace

Eigen::Vector3d unit_vector(const Eigen::Vector3d& vector, const std::string& where) {
  return vector / length_of(vector, where);
}

Plane normalized_plane(const Eigen::Vector4d& numbers, const std::string& where) {
  const double length = length_of(numbers.head<3>(), where);
  const double offset = numbers[3] / length;
  if (!std::isfinite(offset)) throw InputError(where, "a plane", "one at infinity");
  return {numbers.head<3>() / length, offset};
}

}  // namespace symscene
