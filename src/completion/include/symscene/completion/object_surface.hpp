#pragma once

#include <optional>

#include "symscene/completion/completion.hpp"

namespace symscene {

struct ObjectSurfaceOptions {
  double voxel_size = 0.003;
  int max_nodes = 120000;
  double reach = 0.008;
  double image_tolerance = 0.0075;
  double max_base_gap = 0.03;
  double max_wall = 0.012;
  double min_cavity = 0.02;
  double min_piece = 0.05;
  double observed_reach = 0.0075;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", between(5e-4, 0.1),
          "edge of the cells in which the surface is extracted; flat objects get down to 40 % of "
          "it, large ones more");
    visit("max_nodes", self.max_nodes, "", between(1000, 1 << 26),
          "most nodes of the field of an object");
    visit("reach", self.reach, "m", above_up_to(0.0, 0.1),
          "radius of the mean over points; somewhat more than their spacing");
    visit("image_tolerance", self.image_tolerance, "m", at_least(0.0),
          "the surface reaches no farther into space whose image under a symmetry was seen empty, "
          "except near observed points; at least 1.5 voxels of the occupancy");
    visit("max_base_gap", self.max_base_gap, "m", at_least(0.0),
          "an object whose lowest points are at most this far above the table stands on it; others "
          "end at their lowest points");
    visit("max_wall", self.max_wall, "m", above_up_to(0.0, 0.1),
          "thickest wall of a vessel: the hidden side of an object with thinner walls around a "
          "cavity is as thin");
    visit("min_cavity", self.min_cavity, "m", above_up_to(0.0, 10.0),
          "least depth of a cavity; a large value disables thin walls");
    visit("min_piece", self.min_piece, "", between(0.0, 1.0),
          "least volume of a piece relative to the largest; smaller ones are removed");
    visit("observed_reach", self.observed_reach, "m", above_up_to(0.0, 0.1),
          "a triangle is observed if at least two of its corners are within this distance of "
          "observed points; at least 1.5 cells");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// What is known about the space around an object. World frame.
struct SurroundingSpace {
  const DistanceField& field;
  const std::optional<Plane>& table;
};

/// The closed surface of an object: zero of a signed field on a lattice. Near points, observed or
/// images under the symmetries, the field is their signed distance; elsewhere the object ends at
/// its visible hull, which is the convex hull of its points and their projections onto its base
/// without what was seen empty and without the images of that under the symmetries. Pockets that
/// nothing connects with the outside are filled, also if they were seen empty. The object stands
/// on the table or ends at its lowest points. If cells are not larger than the voxels of
/// `space`, no vertex lies more than a voxel inside space that was seen empty, pockets aside. Each
/// edge has exactly two triangles. Without oriented points the surface is empty.
/// `completion.square_tolerance` is that of complete_object(). Throws InputError on invalid
/// options.
ObjectSurface object_surface(const CompletedObject& object, const SurroundingSpace& space,
                             const ObjectSurfaceOptions& options = {},
                             const CompletionOptions& completion = {});

}  // namespace symscene
