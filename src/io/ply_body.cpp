#include "ply_body.hpp"

#include <fmt/format.h>

#include "file_end.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {

void PlyBody::skip(const PlyElement& element) {
  walk(
      element, [](auto...) {}, [](auto...) {});
}

void PlyBody::require_end() const { symscene::require_end(rest_, name_); }

Eigen::MatrixXf PlyBody::read_columns(const PlyElement& element,
                                      std::span<const std::size_t> properties) {
  require_rows(element);
  if (encoding_ != PlyEncoding::ascii && !element.has_lists()) {
    return copy_columns(element, properties);
  }
  constexpr Eigen::Index unwanted = -1;
  std::vector<Eigen::Index> column_of(element.properties.size(), unwanted);
  for (std::size_t k = 0; k < properties.size(); ++k) {
    column_of[properties[k]] = static_cast<Eigen::Index>(k);
  }
  Eigen::MatrixXf columns(static_cast<Eigen::Index>(element.count),
                          static_cast<Eigen::Index>(properties.size()));
  walk(
      element,
      [&](std::uint64_t row, std::size_t property, double value) {
        const Eigen::Index column = column_of[property];
        if (column == unwanted) return;
        columns(static_cast<Eigen::Index>(row), column) = static_cast<float>(value);
      },
      [](auto...) {});
  return columns;
}

void PlyBody::read_lists(const PlyElement& element, std::size_t property,
                         const std::function<void(std::span<const double>)>& visit) {
  walk(
      element, [](auto...) {},
      [&](std::size_t p, std::span<const double> values) {
        if (p == property) visit(values);
      });
}

/// The least number of bytes of a value; in text a digit and a separator.
std::size_t PlyBody::least_size(ScalarType type) const {
  return encoding_ == PlyEncoding::ascii ? 2 : size_of(type);
}

void PlyBody::require_rows(const PlyElement& element) const {
  std::size_t least_row = 0;
  for (const PlyProperty& property : element.properties) {
    least_row += least_size(property.length_type.value_or(property.type));
  }
  // The last value of a text file needs no separator.
  const std::size_t available = rest_.size() + (encoding_ == PlyEncoding::ascii ? 1 : 0);
  if (least_row == 0 || element.count <= available / least_row) return;
  throw InputError(name_, fmt::format("{} rows of element {}", element.count, element.name),
                   fmt::format("only {} bytes", rest_.size()));
}

bool PlyBody::swaps() const {
  return (encoding_ == PlyEncoding::big_endian) != (std::endian::native == std::endian::big);
}

Eigen::MatrixXf PlyBody::copy_columns(const PlyElement& element,
                                      std::span<const std::size_t> properties) {
  std::vector<std::size_t> offsets;
  std::size_t stride = 0;
  for (const PlyProperty& property : element.properties) {
    offsets.push_back(stride);
    stride += size_of(property.type);
  }
  Eigen::MatrixXf columns(static_cast<Eigen::Index>(element.count),
                          static_cast<Eigen::Index>(properties.size()));
  for (std::size_t k = 0; k < properties.size(); ++k) {
    const std::size_t p = properties[k];
    copy_column(
        {rest_.data() + offsets[p], stride, element.count, element.properties[p].type, swaps()},
        columns.col(static_cast<Eigen::Index>(k)).data());
  }
  rest_.remove_prefix(stride * element.count);
  return columns;
}

template <class OnValue, class OnList>
void PlyBody::walk(const PlyElement& element, const OnValue& on_value, const OnList& on_list) {
  require_rows(element);
  if (element.properties.empty()) return;
  std::vector<double> list;
  for (std::uint64_t row = 0; row < element.count; ++row) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.is_list()) {
        next_list(property, list);
        on_list(p, std::span<const double>(list));
      } else {
        on_value(row, p, next_value(property.type));
      }
    }
  }
}

double PlyBody::next_value(ScalarType type) {
  if (encoding_ == PlyEncoding::ascii) return next_ascii_value();
  const std::size_t size = size_of(type);
  if (rest_.size() < size) throw InputError(name_, "more values", "the end of the file");
  const double value = load_as_double(type, rest_.data(), swaps());
  rest_.remove_prefix(size);
  return value;
}

double PlyBody::next_ascii_value() {
  const std::string_view word = next_word(rest_);
  if (word.empty()) throw InputError(name_, "more values", "the end of the file");
  const auto value = to_number<double>(word);
  if (!value) throw InputError(name_, "a number", in_quotes(word));
  return *value;
}

void PlyBody::next_list(const PlyProperty& property, std::vector<double>& values) {
  const double length = next_value(*property.length_type);
  const auto available = static_cast<double>(rest_.size() / least_size(property.type) + 1);
  if (!(length >= 0 && length <= available)) {
    throw InputError(name_, fmt::format("a length of list {} that fits the file", property.name),
                     fmt::format("{}", length));
  }
  values.resize(static_cast<std::size_t>(length));
  for (double& value : values) value = next_value(property.type);
}

}  // namespace symscene
