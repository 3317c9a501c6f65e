#pragma once

#include "simulation/true_surface.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// The mesh on which most of the observed points of a found object are, of those within 2 cm of
/// one; TrueSurface::Nearest::nothing if there is none. `meshes`: their number in `surface`.
Index found_mesh(const Points& points, const TrueSurface& surface, std::size_t meshes);

}  // namespace symscene
