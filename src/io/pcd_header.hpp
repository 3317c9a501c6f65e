#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "scalar.hpp"

namespace symscene {

enum class PcdEncoding { ascii, binary, binary_compressed };

struct PcdField {
  std::string name;
  ScalarType type = ScalarType::float32;
  std::size_t count = 1;         ///< values per point
  std::size_t offset = 0;        ///< from the beginning of a point [byte]
  std::size_t first_column = 0;  ///< number of values before it in a point
};

struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint64_t points = 0;
  std::size_t point_bytes = 0;
  std::size_t point_values = 0;
  PcdEncoding encoding = PcdEncoding::ascii;
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();  ///< position of the sensor [m]
  std::size_t size = 0;                                 ///< bytes before the body

  const PcdField* find(std::string_view field) const;
};

/// Throws InputError if `bytes` do not begin with a PCD header.
PcdHeader parse_pcd_header(std::string_view bytes, const std::string& name);

}  // namespace symscene
