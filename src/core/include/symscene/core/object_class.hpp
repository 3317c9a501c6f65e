#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// Symmetries that an object has together (section 4.7).
enum class SymmetryClass : std::uint8_t {
  none,        ///< no symmetry is known
  mirror,      ///< one plane
  prism,       ///< two perpendicular planes
  box,         ///< three perpendicular planes
  n_fold,      ///< an axis about which the object repeats every 2π / order
  revolution,  ///< an axis of any rotation
  cylinder,    ///< an axis of any rotation and a plane across it
  sphere       ///< a centre: every axis and plane through it
};

/// "none", "mirror", "prism", "box", "n_fold", "revolution", "cylinder" or "sphere".
const char* to_string(SymmetryClass kind);
/// The class of that name; none for another text.
std::optional<SymmetryClass> symmetry_class_of(std::string_view name);

/// A length of an object.
struct Dimension {
  std::string name;    ///< "length", "width", "height", "radius" or "apothem"
  double value = 0.0;  ///< the estimate; without `sigma` a lower bound [m]
  std::optional<double> sigma =
      {};                   ///< standard deviation; none where the points do not constrain it [m]
  std::string reason = {};  ///< why there is no sigma
};

/// The symmetry class of an object and its parameters, fitted together. World frame.
struct ObjectClass {
  SymmetryClass kind = SymmetryClass::none;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< on all planes and axes [m]
  /// Orthonormal columns. Normals of the planes: the first of a mirror, the first two of a prism,
  /// all of a box, whose third is nearest to the table's normal. For other classes the third is the
  /// axis.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  int order = 0;           ///< of n_fold
  double residual = 0.0;   ///< root mean square distance of the explained points; 0 if unknown [m]
  double explained = 0.0;  ///< share of the points that the class explains
  /// Of a surface that is a box, a regular prism, a cylinder or a sphere; otherwise none.
  std::vector<Dimension> dimensions = {};
};

}  // namespace symscene
