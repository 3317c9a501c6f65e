#pragma once

#include <pybind11/pybind11.h>

#include "symscene/core/camera.hpp"

namespace symscene::python {

/// Intrinsics of an image of this size from a CameraIntrinsics, (fx, fy, cx, cy) or a 3×3 matrix.
/// Throws InputError for another value, for focal lengths that are not positive, a principal point
/// outside the image, or the intrinsics of images of another size.
CameraIntrinsics intrinsics_from(pybind11::handle value, Index width, Index height);

}  // namespace symscene::python
