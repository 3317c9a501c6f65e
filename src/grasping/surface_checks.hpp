#pragma once

#include <cstddef>

#include "symscene/core/scene.hpp"

namespace symscene {

/// Throws InputError if the surface of object `id` is so large, as one in millimetres is, that its
/// samples would not fit into memory.
void require_moderate_size(const ObjectSurface& surface, std::size_t id);

}  // namespace symscene
