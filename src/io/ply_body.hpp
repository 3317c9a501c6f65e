#pragma once

#include <functional>
#include <span>

#include <Eigen/Core>

#include "ply_header.hpp"

namespace symscene {

/// Reads the elements after a PLY header in order. Each declared size is checked against the
/// remaining bytes before anything is allocated; all members throw InputError if it does not fit.
class PlyBody {
 public:
  PlyBody(std::string_view bytes, PlyEncoding encoding, std::string name)
      : rest_(bytes), encoding_(encoding), name_(std::move(name)) {}

  void skip(const PlyElement& element);

  /// Of a file whose elements have all been read.
  void require_end() const;

  /// The single-value properties of an element at these positions, one column each.
  Eigen::MatrixXf read_columns(const PlyElement& element, std::span<const std::size_t> properties);

  /// Calls visit(values) with the list of every row.
  void read_lists(const PlyElement& element, std::size_t property,
                  const std::function<void(std::span<const double>)>& visit);

 private:
  void require_rows(const PlyElement& element) const;
  std::size_t least_size(ScalarType type) const;
  double next_value(ScalarType type);
  double next_ascii_value();
  void next_list(const PlyProperty& property, std::vector<double>& values);
  bool swaps() const;
  Eigen::MatrixXf copy_columns(const PlyElement& element, std::span<const std::size_t> properties);
  template <class OnValue, class OnList>
  void walk(const PlyElement& element, const OnValue& on_value, const OnList& on_list);

  std::string_view rest_;
  PlyEncoding encoding_;
  std::string name_;
};

}  // namespace symscene
