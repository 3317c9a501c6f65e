#pragma once

#include "reconstruction/surface_image.hpp"
#include "symscene/reconstruction/measurement_options.hpp"

namespace symscene {

/// Gives all pixels of a plane that dominates an image, such as a table with few objects, one
/// normal; returns whether there is such a plane. Normals of a fused table still scatter by a
/// degree or more at 2 m; in Σ n nᵀ that looks like a constraint on motions along the table, which
/// outweighs the constraints of two or three small objects on it. A pixel lies on the plane if its
/// inverse depth deviates by at most `options.pixel_deviations` of `noise` [1/m] and its normal by
/// at most `options.max_angle`. The plane is searched from random triples of pixels (Fischler and
/// Bolles 1981), always the same ones for an image.
bool flatten_dominant_plane(SurfaceImage& image, double noise,
                            const DominantPlaneOptions& options = {});

}  // namespace symscene
