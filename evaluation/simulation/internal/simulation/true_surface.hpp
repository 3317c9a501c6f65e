#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Nearest-point queries on the surfaces of meshes. Queries may run from many threads at once;
/// their results do not depend on the order in which triangles are visited.
class TrueSurface {
 public:
  struct Nearest {
    static constexpr Index nothing = ~Index{0};

    Index mesh = nothing;   ///< its number in the span
    double distance = 0.0;  ///< unsigned; the search radius if no surface is within it [m]
  };

  /// Copies the meshes.
  explicit TrueSurface(std::span<const TriangleMesh> meshes);
  ~TrueSurface();
  TrueSurface(TrueSurface&&) noexcept;
  TrueSurface& operator=(TrueSurface&&) noexcept;

  /// The mesh nearest to a point within `radius` [m].
  Nearest nearest(const Eigen::Vector3d& point, double radius) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Distances of points from the true surfaces.
struct SurfaceErrors {
  std::vector<float> distances;  ///< per point, at most the search radius [m]
  double median = 0.0;           ///< [m]
  double percentile_90 = 0.0;    ///< [m]
  double percentile_95 = 0.0;    ///< [m]
  double within_reach = 0.0;     ///< share of the points within the search radius
};

/// The distances of points, such as the vertices of a reconstructed mesh, to the nearest of
/// `meshes` or the table. All in one frame. Zero without points.
SurfaceErrors surface_errors(const Points& points, std::span<const TriangleMesh> meshes,
                             const std::optional<Plane>& table, double reach = 0.05);

}  // namespace symscene
