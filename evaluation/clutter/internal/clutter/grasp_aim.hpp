#pragma once

#include "simulation/true_surface.hpp"
#include "symscene/core/grasp.hpp"

namespace symscene {

/// The mesh that a grasp of the Panda hand aims at: the one nearest to the point between the
/// fingertips. Mesh 0 if none is within 0.5 m.
TrueSurface::Nearest aim_of(const Grasp& grasp, const TrueSurface& surface);

}  // namespace symscene
