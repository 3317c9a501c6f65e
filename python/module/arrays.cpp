#include "arrays.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Bytes = py::array_t<std::uint8_t, py::array::c_style>;

/// An array of numbers. Throws InputError for all else.
py::array numbers(py::handle value, const std::string& name, const char* expected) {
  const py::array array = py::array::ensure(value);
  if (!array) PyErr_Clear();
  const char kind = array ? array.dtype().kind() : 'O';
  if (kind != 'f' && kind != 'i' && kind != 'u') throw InputError(name, expected, described(value));
  return array;
}

Doubles doubles(py::handle value, const std::string& name, const char* expected) {
  return Doubles(numbers(value, name, expected));
}

template <class Matrix>
py::array_t<double> rows_of(const Matrix& matrix) {
  py::array_t<double> array({matrix.rows(), matrix.cols()});
  auto values = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < matrix.rows(); ++i)
    for (py::ssize_t j = 0; j < matrix.cols(); ++j) values(i, j) = matrix(i, j);
  return array;
}

template <class Source>
void to_metres(const py::array& array, double scale, std::vector<float>& depth) {
  const py::array_t<Source, py::array::c_style | py::array::forcecast> values(array);
  const Source* const begin = values.data();
  const auto divisor = static_cast<float>(scale);  // as sequences are read
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const float metres = static_cast<float>(begin[i]) / divisor;
    depth[i] = std::isfinite(metres) && metres > 0.0F ? metres : 0.0F;
  }
}

}  // namespace

py::array view(const Owner& owner, const Points& points) {
  return view(owner, points.data(), {points.rows(), 3}, {1, points.rows()});
}

py::array view(const Owner& owner, const Colors& colors) {
  return view(owner, colors.data(), {colors.rows(), 3}, {3, 1});
}

py::array view(const Owner& owner,
               const Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>& triangles) {
  return view(owner, triangles.data(), {triangles.rows(), 3}, {3, 1});
}

py::array_t<double> array_of(const Eigen::Vector3d& vector) {
  return py::array_t<double>(py::ssize_t{3}, vector.data());
}

py::array_t<double> array_of(const Eigen::Matrix3d& matrix) { return rows_of(matrix); }

py::array_t<double> array_of(const Eigen::Isometry3d& pose) { return rows_of(pose.matrix()); }

py::array_t<double> array_of(const Plane& plane) {
  const std::array<double, 4> values = {plane.normal.x(), plane.normal.y(), plane.normal.z(),
                                        plane.offset};
  return py::array_t<double>(py::ssize_t{4}, values.data());
}

py::array_t<double> array_of(const Trajectory& trajectory) {
  py::array_t<double> array(
      {static_cast<py::ssize_t>(trajectory.size()), py::ssize_t{4}, py::ssize_t{4}});
  auto values = array.mutable_unchecked<3>();
  for (py::ssize_t k = 0; k < values.shape(0); ++k) {
    const Eigen::Matrix4d pose = trajectory[static_cast<std::size_t>(k)].T_world_camera.matrix();
    for (py::ssize_t i = 0; i < 4; ++i)
      for (py::ssize_t j = 0; j < 4; ++j) values(k, i, j) = pose(i, j);
  }
  return array;
}

py::list list_of(const std::vector<StageTime>& times) {
  py::list list;
  for (const StageTime& time : times) list.append(py::make_tuple(time.stage, time.seconds));
  return list;
}

std::string described(py::handle value) {
  if (!py::isinstance<py::array>(value))
    return "a value of type " + std::string(py::str(py::type::of(value).attr("__name__")));
  const auto array = py::reinterpret_borrow<py::array>(value);
  return fmt::format("an array of shape {} and type {}", std::string(py::str(array.attr("shape"))),
                     std::string(py::str(array.dtype())));
}

Points points_from(py::handle value, const std::string& name) {
  constexpr const char* expected = "an array of numbers of shape (N, 3)";
  const Doubles array = doubles(value, name, expected);
  if (array.ndim() != 2 || array.shape(1) != 3) throw InputError(name, expected, described(value));
  const auto values = array.unchecked<2>();
  Points points(values.shape(0), 3);
  for (py::ssize_t i = 0; i < values.shape(0); ++i)
    for (py::ssize_t j = 0; j < 3; ++j) points(i, j) = static_cast<float>(values(i, j));
  return points;
}

Colors colors_from(py::handle value, const std::string& name) {
  constexpr const char* expected = "an array of uint8 of shape (N, 3) or (height, width, 3)";
  const py::array array = numbers(value, name, expected);
  const bool is_shaped =
      (array.ndim() == 2 || array.ndim() == 3) && array.shape(array.ndim() - 1) == 3;
  if (!is_shaped || !array.dtype().is(py::dtype::of<std::uint8_t>()))
    throw InputError(name, expected, described(value));
  const Bytes bytes(array);
  Colors colors(bytes.size() / 3, 3);
  std::copy_n(bytes.data(), bytes.size(), colors.data());
  return colors;
}

std::vector<double> numbers_from(py::handle value, std::size_t count, const std::string& name) {
  const std::string expected = fmt::format("{} finite numbers", count);
  const Doubles array = doubles(value, name, expected.c_str());
  if (array.ndim() != 1 || static_cast<std::size_t>(array.size()) != count)
    throw InputError(name, expected, described(array));
  std::vector<double> values(array.data(), array.data() + count);
  for (const double number : values) {
    if (!std::isfinite(number)) throw InputError(name, expected, fmt::format("{}", number));
  }
  return values;
}

Eigen::Vector3d vector_from(py::handle value, const std::string& name) {
  const std::vector<double> values = numbers_from(value, 3, name);
  return {values[0], values[1], values[2]};
}

Eigen::Isometry3d pose_from(py::handle value, const std::string& name) {
  constexpr const char* expected = "a pose as an array of numbers of shape (4, 4)";
  const Doubles array = doubles(value, name, expected);
  if (array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4)
    throw InputError(name, expected, described(value));
  const auto values = array.unchecked<2>();
  Eigen::Isometry3d pose;
  for (py::ssize_t i = 0; i < 4; ++i)
    for (py::ssize_t j = 0; j < 4; ++j) pose.matrix()(i, j) = values(i, j);
  if (pose.matrix().row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
    throw InputError(name, "a pose whose last row is 0, 0, 0, 1", "another row");
  return pose;
}

DepthArray depth_from(py::handle value, std::optional<double> scale, const std::string& name) {
  constexpr const char* expected = "a depth image: an array of numbers of shape (height, width)";
  const py::array array = numbers(value, name, expected);
  if (array.ndim() != 2 || array.size() == 0) throw InputError(name, expected, described(value));
  constexpr py::ssize_t most = 1 << 24;  // pixels, as of images that are read
  if (array.size() > most)
    throw InputError(name, "a depth image of at most 2^24 pixels", described(value));
  const bool is_metric = array.dtype().kind() == 'f';
  const double divisor = scale.value_or(is_metric ? 1.0 : 1000.0);
  if (!(divisor > 0.0) || !std::isfinite(1.0F / static_cast<float>(divisor)))
    throw InputError("depth_scale", "a number above 0", fmt::format("{}", divisor));
  DepthArray result{static_cast<Index>(array.shape(1)), static_cast<Index>(array.shape(0)), {}};
  result.depth.resize(static_cast<std::size_t>(array.size()));
  if (is_metric)
    to_metres<double>(array, divisor, result.depth);
  else
    to_metres<std::int64_t>(array, divisor, result.depth);
  return result;
}

}  // namespace symscene::python
