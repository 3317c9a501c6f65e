#pragma once

#include <array>

#include "symmetry/score_range.hpp"
#include "symscene/core/object_class.hpp"

namespace symscene {

/// What a point may deviate from a surface and still be on it.
struct SurfaceBounds {
  ScoreRange distance;  ///< of a point from a face [m]
  ScoreRange angle;     ///< between the normals of a point and of a face [rad]
};

/// The closed convex surface of a class with dimensions: a box, a regular prism, a cylinder or a
/// sphere. An end that is hidden does not bound the faces beside it.
class ClassSurface {
 public:
  /// The greatest order of a prism.
  static constexpr int max_order = 6;

  /// `found` has dimensions.
  explicit ClassSurface(const ObjectClass& found);

  /// 0 for a point on a face with the face's normal, 1 for one that no face explains.
  float residual(const Eigen::Vector3f& position, const Eigen::Vector3f& normal,
                 const SurfaceBounds& bounds) const;

 private:
  /// A face at a local point.
  struct Face {
    Eigen::Vector3d normal;
    double distance = 0.0;  ///< signed, positive outside [m]
    bool is_end = true;     ///< the surface is known to end there
  };
  struct Faces {
    std::array<Face, max_order + 2> all;
    std::size_t count = 0;
    void add(const Face& face) { all[count++] = face; }
  };

  Faces faces_at(const Eigen::Vector3d& local) const;
  void add_ends(int axis, const Eigen::Vector3d& local, Faces& faces) const;
  void add_sides(const Eigen::Vector3d& local, Faces& faces) const;

  SymmetryClass kind_;
  int order_;
  Eigen::Vector3d center_;
  Eigen::Matrix3d axes_;
  double size_ = 0.0;                                       ///< radius or apothem [m]
  Eigen::Vector3d half_extents_ = Eigen::Vector3d::Zero();  ///< along the axes with ends [m]
  std::array<bool, 3> is_determined_{};                     ///< whether both ends are known
};

}  // namespace symscene
