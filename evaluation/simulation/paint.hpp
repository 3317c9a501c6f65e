#pragma once

#include "core/random.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// Colours for the vertices of one object: a random base with a band of a second colour, stripes
/// and a mottle, all functions of the place.
Colors paint(const Points& vertices, Random& random);

}  // namespace symscene
