#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <Eigen/Geometry>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/stage_timer.hpp"
#include "symscene/core/types.hpp"

namespace symscene::python {

namespace py = pybind11;

/// What keeps the memory of an array alive.
using Owner = std::shared_ptr<const void>;

/// A read-only array on memory of `owner`, without a copy. Strides are in values.
template <class Value>
py::array view(const Owner& owner, const Value* data, const std::vector<py::ssize_t>& shape,
               std::vector<py::ssize_t> strides) {
  static const Value nothing{};
  auto* const kept = new Owner(owner);
  const py::capsule base(kept, [](void* memory) { delete static_cast<Owner*>(memory); });
  for (py::ssize_t& stride : strides) stride *= static_cast<py::ssize_t>(sizeof(Value));
  py::array array(py::dtype::of<Value>(), shape, strides, data == nullptr ? &nothing : data, base);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// N×3 float32. The three columns are contiguous, not the rows.
py::array view(const Owner& owner, const Points& points);
/// N×3 uint8.
py::array view(const Owner& owner, const Colors& colors);
/// T×3 uint32.
py::array view(const Owner& owner,
               const Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>& triangles);

/// A list of values.
template <class Value>
py::array view(const Owner& owner, const std::vector<Value>& values) {
  return view(owner, values.data(), {static_cast<py::ssize_t>(values.size())}, {1});
}

/// Copies of small values, float64.
py::array_t<double> array_of(const Eigen::Vector3d& vector);
py::array_t<double> array_of(const Eigen::Matrix3d& matrix);
py::array_t<double> array_of(const Eigen::Isometry3d& pose);  ///< 4×4
py::array_t<double> array_of(const Plane& plane);             ///< a, b, c, d
py::array_t<double> array_of(const Trajectory& trajectory);   ///< N×4×4

/// None where there is no value.
template <class Value>
py::object array_or_none(const std::optional<Value>& value) {
  if (!value) return py::none();
  return array_of(*value);
}

/// List of (stage, seconds).
py::list list_of(const std::vector<StageTime>& times);

/// "an array of shape (4, 2)", or the type of what is no array.
std::string described(py::handle value);

// Values from arrays. Each throws InputError, which names `name`, if the value has another shape,
// holds no numbers, or is no array.

Points points_from(py::handle value, const std::string& name);
Colors colors_from(py::handle value, const std::string& name);  ///< N×3 or H×W×3, uint8
Eigen::Vector3d vector_from(py::handle value, const std::string& name);
Eigen::Isometry3d pose_from(py::handle value, const std::string& name);
/// `count` finite numbers.
std::vector<double> numbers_from(py::handle value, std::size_t count, const std::string& name);

/// Depths of H×W values. Integers are divided by `scale` (by default 1000: millimetres), floats by
/// default are metres. Values that are not finite or not positive become 0: not measured.
struct DepthArray {
  Index width = 0;
  Index height = 0;
  std::vector<float> depth;  ///< [m]
};
DepthArray depth_from(py::handle value, std::optional<double> scale, const std::string& name);

}  // namespace symscene::python
