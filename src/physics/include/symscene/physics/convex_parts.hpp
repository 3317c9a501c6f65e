#pragma once

#include <vector>

#include "symscene/core/options.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

struct ConvexPartsOptions {
  double concavity = 0.004;  ///< depth of a hollow from which its mesh is cut [m]
  double cell = 0.005;       ///< cells that the mesh is thinned with before [m]
  int max_cells = 36;        ///< along the diagonal: the cells of large meshes are larger
  int max_parts = 32;        ///< the smallest are joined with a neighbour until they are no more
  double skin = 0.001;       ///< thickness that a part has at least [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("concavity", self.concavity, "m", "depth of a hollow from which a mesh is cut");
    visit("cell", self.cell, "m", "cells that a mesh is thinned with before it is cut");
    visit("max_cells", self.max_cells, "", "along the diagonal: large meshes have larger cells");
    visit("max_parts", self.max_parts, "", "small parts are joined until they are no more");
    visit("skin", self.skin, "m", "thickness that a convex part has at least");
  }
  void validate() const;
};

/// Whether a mesh has finite vertices and reaches at least a millimetre in every direction.
bool is_solid(const TriangleMesh& mesh);

/// Points whose convex hulls together are about the solid. [m]
using ConvexParts = std::vector<Points>;

/// Cuts a mesh into parts that are nearly convex, as physics collides nothing else: without it a
/// bowl has no inside. Neighbouring triangles are joined bottom up, as in Mamou and Ghorbel, "A
/// simple and efficient approach for 3D mesh approximate convex decomposition", ICIP 2009, with a
/// cost that needs no hulls: the depth of a part below planes that touch it. The parts are found on
/// a thinned mesh and hold the vertices of the mesh itself.
/// Throws InputError if the mesh is no solid.
ConvexParts convex_parts(const TriangleMesh& mesh, const ConvexPartsOptions& options = {});

}  // namespace symscene
