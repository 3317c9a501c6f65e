#pragma once

#include "reconstruction/surface_image.hpp"
#include "symscene/reconstruction/measurement_options.hpp"

namespace symscene {

/// Gives the pixels of planar windows the normal of their plane. A normal from neighbouring pixels
/// has so much noise that a large table seems to constrain motions along itself (Σ n nᵀ adds the
/// noise of all its pixels), which outweighs the constraints of small objects; at
/// 2 m a hundredfold. Windows are planar if the inverse depths in them
/// deviate from a plane by no more than `noise` [1/m]. Normals of other pixels stay.
void smooth_planar_normals(SurfaceImage& image, double noise,
                           const PlanarNormalOptions& options = {});

}  // namespace symscene
