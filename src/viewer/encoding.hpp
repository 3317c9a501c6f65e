#pragma once

#include <nlohmann/json.hpp>

#include "symscene/core/types.hpp"

namespace symscene {

nlohmann::json encode(const Eigen::Vector3d& vector);

/// Positions in steps of 16 bits over their box, or as floats where these steps would be coarse.
/// Throws InputError if one is not finite.
nlohmann::json encode_positions(const Points& points);

/// A signed byte a coordinate; a normal that is not finite counts as none.
std::string encode_normals(const Points& normals);

std::string encode_colors(const Colors& colors);

}  // namespace symscene
