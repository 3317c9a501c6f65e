#pragma once

#include "symscene/core/options.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The part of a reconstructed surface that a page shows.
struct PageSurfaceOptions {
  double margin = 0.25;
  int max_triangles = 250'000;
  double smallest_cell = 0.004;
  double reach = 0.02;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("margin", self.margin, "m", at_least(0.0),
          "the surface is shown this far beyond the ball that holds the objects");
    visit("max_triangles", self.max_triangles, "", at_least(1.0),
          "a larger surface is thinned; 250,000 triangles take 2.7 MB of the page");
    visit("smallest_cell", self.smallest_cell, "m", above(0.0),
          "finest grid on which a larger surface is thinned");
    visit("reach", self.reach, "m", above(0.0),
          "a point lies on the surface if a vertex is this near");
  }
  void validate() const { check_fields(*this); }
};

/// The surface around the objects, or around the cloud if there is no object, or all of it if there
/// is no point (a bare table); thinned if it is large. A surface that is small enough is returned
/// unchanged, so that the function is idempotent.
/// Throws InputError if less than half of the cloud lies on the surface, which then belongs to
/// another scene or frame.
TriangleMesh page_surface(const TriangleMesh& surface, const SegmentationResult& result,
                          const PageSurfaceOptions& options = {});

}  // namespace symscene
