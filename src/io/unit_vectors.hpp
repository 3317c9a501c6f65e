#pragma once

#include <string>

#include "symscene/core/geometry.hpp"

namespace symscene {

/// `vector` scaled to unit length; unchanged if it has unit length already, so that
/// writing and reading give the same bits. Throws InputError if it has no length.
Eigen::Vector3d unit_vector(const Eigen::Vector3d& vector, const std::string& where);

/// The plane of a, b, c, d in ax + by + cz + d = 0. Throws InputError if a, b, c are all zero.
Plane normalized_plane(const Eigen::Vector4d& numbers, const std::string& where);

}  // namespace symscene
