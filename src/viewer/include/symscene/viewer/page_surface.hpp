#pragma once

#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// How much of a reconstructed surface is shown around the objects.
struct PageSurfaceOptions {
  float margin = 0.25F;           ///< around the ball that holds the objects [m]
  Index max_triangles = 250'000;  ///< some 2.7 MB of the page
  float smallest_cell = 0.004F;   ///< of the grid on which a larger surface is thinned [m]
  float reach = 0.02F;  ///< a point of the cloud this near a vertex lies on the surface [m]

  void validate() const;  // throws InputError
};

/// The surface around the objects, around the cloud where there is no object, thinned where it is
/// large. What is small enough stays as it is, so that doing it twice changes nothing.
/// Throws InputError if less than half of the cloud lies on the surface: it is then of another
/// scene or in another frame.
TriangleMesh page_surface(const TriangleMesh& surface, const SegmentationResult& result,
                          const PageSurfaceOptions& options = {});

}  // namespace symscene
