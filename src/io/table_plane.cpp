#include "symscene/io/table_plane.hpp"

#include <cmath>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"
#include "unit_vectors.hpp"

namespace symscene {
namespace {

constexpr const char* four_numbers = "four numbers a b c d, the plane ax + by + cz + d = 0";

}  // namespace

Plane parse_table_plane(std::string_view text, const std::string& name) {
  Eigen::Vector4d numbers;
  for (Eigen::Index k = 0; k < numbers.size(); ++k) {
    const std::string_view word = next_word(text);
    if (word.empty()) throw InputError(name, four_numbers, fmt::format("only {}", k));
    const auto value = to_number<double>(word);
    if (!value || !std::isfinite(*value)) throw InputError(name, four_numbers, in_quotes(word));
    numbers[k] = *value;
  }
  const std::string_view extra = next_word(text);
  if (!extra.empty()) throw InputError(name, four_numbers, "more: " + in_quotes(extra));
  return normalized_plane(numbers, name);
}

Plane read_table_plane(const std::filesystem::path& path) {
  return parse_table_plane(read_file(path), path.string());
}

std::string format_table_plane(const Plane& plane) {
  return fmt::format("{}\n{}\n{}\n{}\n", plane.normal.x(), plane.normal.y(), plane.normal.z(),
                     plane.offset);
}

}  // namespace symscene
