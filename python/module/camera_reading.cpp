#include "camera_reading.hpp"

#include <fmt/format.h>

#include "arrays.hpp"
#include "symscene/core/error.hpp"

namespace symscene::python {
namespace {

constexpr const char* expected =
    "CameraIntrinsics, (fx, fy, cx, cy) in pixels, or a matrix of shape (3, 3)";

CameraIntrinsics of_matrix(const py::array& array, Index width, Index height) {
  const auto k = array.unchecked<double, 2>();
  if (k(0, 1) != 0.0 || k(1, 0) != 0.0 || k(2, 0) != 0.0 || k(2, 1) != 0.0 || k(2, 2) != 1.0)
    throw InputError("intrinsics", "a matrix [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]",
                     "other values off its diagonal");
  return {width, height, k(0, 0), k(1, 1), k(0, 2), k(1, 2)};
}

CameraIntrinsics of_array(py::handle value, Index width, Index height) {
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
  if (!array) {
    PyErr_Clear();
    throw InputError("intrinsics", expected, described(value));
  }
  if (array.ndim() == 2 && array.shape(0) == 3 && array.shape(1) == 3)
    return of_matrix(array, width, height);
  if (array.ndim() != 1 || array.size() != 4)
    throw InputError("intrinsics", expected, described(array));
  const double* const k = array.data();
  return {width, height, k[0], k[1], k[2], k[3]};
}

void require_valid(const CameraIntrinsics& camera) {
  if (!(camera.fx > 0.0 && camera.fy > 0.0 && std::isfinite(camera.fx + camera.fy)))
    throw InputError("intrinsics", "focal lengths above 0",
                     fmt::format("fx {}, fy {}", camera.fx, camera.fy));
  const bool is_inside = camera.cx >= -0.5 && camera.cy >= -0.5 &&
                         camera.cx <= camera.width - 0.5 && camera.cy <= camera.height - 0.5;
  if (!is_inside)
    throw InputError(
        "intrinsics",
        fmt::format("a principal point in the image of {}x{} pixels", camera.width, camera.height),
        fmt::format("cx {}, cy {}", camera.cx, camera.cy));
}

}  // namespace

CameraIntrinsics intrinsics_from(py::handle value, Index width, Index height) {
  const bool is_camera = py::isinstance<CameraIntrinsics>(value);
  const CameraIntrinsics camera =
      is_camera ? value.cast<CameraIntrinsics>() : of_array(value, width, height);
  if (camera.width != width || camera.height != height)
    throw InputError(
        "depth",
        fmt::format("an image of {}x{} pixels, as intrinsics tell", camera.width, camera.height),
        fmt::format("{}x{}", width, height));
  require_valid(camera);
  return camera;
}

}  // namespace symscene::python
