#pragma once

#include <nlohmann/json.hpp>

#include "symscene/core/types.hpp"

namespace symscene {

nlohmann::json encode(const Eigen::Vector3d& vector);

/// Positions quantized to 16 bits over their bounding box, or floats if the box is too large for
/// that. Throws InputError if a position is not finite.
nlohmann::json encode_positions(const Points& points);

/// One signed byte per coordinate; zeros for a normal that is not finite.
std::string encode_normals(const Points& normals);

std::string encode_colors(const Colors& colors);

}  // namespace symscene
