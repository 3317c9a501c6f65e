#pragma once

#include <vector>

#include "symscene/core/options.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

struct ConvexPartsOptions {
  double concavity = 0.004;
  double cell = 0.005;
  int max_cells = 36;
  int max_parts = 32;
  double skin = 0.001;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("concavity", self.concavity, "m", above(0.0),
          "parts are joined while the depth of the hollows that their hull covers is below this");
    visit("cell", self.cell, "m", above(0.0),
          "edge of the cells in which a mesh is thinned before it is decomposed");
    visit("max_cells", self.max_cells, "", at_least(4),
          "cells along the diagonal of a mesh, at most: large meshes have larger cells");
    visit("max_parts", self.max_parts, "", at_least(1),
          "number of parts, at most: parts are joined regardless of hollows until it is reached");
    visit("skin", self.skin, "m", above(0.0), "least thickness of a convex part");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// Whether a mesh has at least 4 triangles and finite vertices and extends over more than 1 mm
/// along each of its principal axes.
bool is_solid(const TriangleMesh& mesh);

/// The vertices of convex hulls whose union approximates a solid, one array of rows per hull, in
/// the frame of its mesh. [m]
using ConvexParts = std::vector<Points>;

/// Decomposes a mesh into nearly convex parts, since rigid-body physics collides convex hulls only:
/// the hull of a bowl has no inside. Neighbouring triangles are joined bottom up, as in Mamou and
/// Ghorbel, "A simple and efficient approach for 3D mesh approximate convex decomposition", ICIP
/// 2009, with a cost that needs no hulls: the depth of a part below planes that touch it. The parts
/// are found on a thinned mesh and hold the vertices of the mesh itself.
/// Throws InputError if an option is out of its range or the mesh is not a solid.
ConvexParts convex_parts(const TriangleMesh& mesh, const ConvexPartsOptions& options = {});

}  // namespace symscene
