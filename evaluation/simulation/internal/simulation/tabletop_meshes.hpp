#pragma once

#include "symscene/simulation/tabletop.hpp"

namespace symscene {

inline constexpr double table_thickness = 0.03;  // [m]

/// The meshes of the objects, followed by that of the table. World frame.
std::vector<TriangleMesh> tabletop_meshes(const Tabletop& tabletop);

}  // namespace symscene
