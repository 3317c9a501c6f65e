#pragma once

#include "symscene/core/error.hpp"

namespace symscene {

/// What the functions of boards do in a build without OpenCV.
[[noreturn]] inline void throw_no_opencv() {
  throw InputError("calibration by a board",
                   "a build with OpenCV (install libopencv-calib3d-dev and "
                   "libopencv-features2d-dev and build again)",
                   "one without");
}

}  // namespace symscene
