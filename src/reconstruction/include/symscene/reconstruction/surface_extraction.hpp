#pragma once

#include "symscene/core/triangle_mesh.hpp"
#include "symscene/reconstruction/tsdf_volume.hpp"

namespace symscene {

struct SurfaceExtractionOptions {
  double min_weight = 1.5;  ///< that all corners of a cell need, in frontal views at 1 m
  int min_triangles = 100;  ///< of a connected piece, smaller ones are left out

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("min_weight", self.min_weight, "", "weight of a cell, in frontal views at 1 m");
    visit("min_triangles", self.min_triangles, "", "of a connected piece of the surface");
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

/// The surface of a volume by marching cubes (Lorensen and Cline 1987), with normals from the
/// gradient of the field and colours where it has them. Ambiguous faces always part the corners
/// that are inside, so that cells meet without a crack: where all of a body is seen its surface is
/// closed and every edge has two triangles. Vertices are shared, also between blocks. The order of
/// vertices and triangles does not depend on the number of threads.
TriangleMesh extract_surface(const TsdfVolume& volume,
                             const SurfaceExtractionOptions& options = {});

/// What is asked of a surface that few frames have seen: bounds are made for 200 frames, fewer are
/// asked for their share of the weight, at least that of one look.
SurfaceExtractionOptions surface_of_few(const SurfaceExtractionOptions& options,
                                        std::size_t frames);

}  // namespace symscene
