#pragma once

#include <array>
#include <string>
#include <vector>

#include "surface_fit.hpp"
#include "symscene/classes/classification.hpp"

namespace symscene {

/// Where a surface ends along a direction of its frame.
struct SurfaceEnd {
  enum class Source { face, edge, table, hidden };

  double offset =
      0.0;  ///< from the origin of the surface; of a hidden end, of the last points before it [m]
  double variance = 0.0;  ///< of an edge or of the table; none of a fitted face [m²]
  Source source = Source::hidden;
};

/// The size of systematic errors, from which those of the ends and of the radius follow. [m]
double systematic_error(const SurfaceFit& fit, double spacing, const ClassOptions& options);

/// The ends of a fitted surface across its planar faces, by their number: an observed face; the
/// table under the object, unless surfaces of `others` carry it; the last points of other faces,
/// where space beyond them was seen empty; or hidden.
std::array<SurfaceEnd, SurfaceModel::planar_faces> surface_ends(const SurfaceFit& fit,
                                                                const ClassifiedObject& object,
                                                                const PointCloud& others,
                                                                double tolerance,
                                                                const ClassOptions& options);

}  // namespace symscene
