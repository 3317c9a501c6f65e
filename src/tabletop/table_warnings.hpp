#pragma once

#include <string>
#include <vector>

#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

/// What users should know about the search for a table, one sentence each: that none was found,
/// that other planes may be meant, or that nothing stands on it. Planes are written as a,b,c,d with
/// ax + by + cz + d = 0.
std::vector<std::string> table_warnings(const TableScene& table);

}  // namespace symscene
