#pragma once

#include "segmentation/surface_part.hpp"
#include "segmentation/workspace.hpp"

namespace symscene {

/// The part of a workspace that is left when objects are removed.
struct Remainder : SurfacePart {
  std::vector<PointIndices> segments;  ///< of the part
};

/// Which hypotheses are removed, and which segments are left.
struct RemovalOptions {
  HypothesisBounds bounds;
  double min_confidence = 0.0;  ///< of the hypotheses that are removed
  int min_segment_size = 1;     ///< points that a segment is left with
};

/// Removes the points of rotational objects before the reflectional stream (section 4.4): of
/// hypotheses within the bounds with enough confidence. Less certain ones may be a part of a larger
/// reflectional object, such as the limb of a toy. Segments lose the removed points; those left
/// with too few are dropped.
Remainder without_rotational_objects(const Workspace& space,
                                     const std::vector<Hypothesis>& hypotheses,
                                     const RemovalOptions& options);

}  // namespace symscene
