#pragma once

#include <memory>
#include <optional>

#include <pybind11/pybind11.h>

#include "symscene/core/camera.hpp"
#include "symscene/core/depth_frame.hpp"

namespace symscene::python {

/// A depth image with its size and, where it is known, its pose.
struct FrameData {
  DepthFrame frame;
  Index width = 0;
  Index height = 0;
  std::optional<Eigen::Isometry3d> T_world_camera = {};
};
struct FrameHandle {
  std::shared_ptr<const FrameData> data;
};

/// A frame from arrays; colour and pose may be None. Throws InputError if one is not valid or
/// colours are not as many as depths.
FrameHandle frame_from(pybind11::handle depth, pybind11::handle color, pybind11::handle pose,
                       double time, std::optional<double> depth_scale);

}  // namespace symscene::python
