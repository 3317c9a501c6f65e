#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The surfaces of meshes, for asking what is nearest. Asking is const and may be done from many
/// threads at once; the answers do not depend on the order in which triangles are looked at.
class TrueSurface {
 public:
  struct Nearest {
    static constexpr Index nothing = ~Index{0};

    Index mesh = nothing;   ///< its place in the span
    double distance = 0.0;  ///< not signed; the radius where there is nothing [m]
  };

  /// Keeps what it needs of the meshes.
  explicit TrueSurface(std::span<const TriangleMesh> meshes);
  ~TrueSurface();
  TrueSurface(TrueSurface&&) noexcept;
  TrueSurface& operator=(TrueSurface&&) noexcept;

  /// What is nearest within `radius` of a point.
  Nearest nearest(const Eigen::Vector3d& point, double radius) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// How far points are from a true surface.
struct SurfaceErrors {
  std::vector<float> distances;  ///< of each point, at most the reach that was looked in [m]
  double median = 0.0;           ///< [m]
  double percentile_90 = 0.0;    ///< [m]
  double percentile_95 = 0.0;    ///< [m]
  double within_reach = 0.0;     ///< share of the points
};

/// The distances of points, such as the vertices of a reconstructed mesh, to the nearest of
/// `meshes` or the table. All in one frame. Zero where there is no point.
SurfaceErrors surface_errors(const Points& points, std::span<const TriangleMesh> meshes,
                             const std::optional<Plane>& table, double reach = 0.05);

}  // namespace symscene
