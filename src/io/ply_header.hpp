#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scalar.hpp"

namespace symscene {

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  ScalarType type;                        ///< of the value, or of a list's values
  std::optional<ScalarType> length_type;  ///< of a list's length; none for a single value

  bool is_list() const { return length_type.has_value(); }
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The position of the property of this name.
  std::optional<std::size_t> find(std::string_view property) const;
  bool has_lists() const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes before the body

  const PlyElement* find(std::string_view element) const;
};

/// Throws InputError if `bytes` do not begin with a PLY header.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

}  // namespace symscene
