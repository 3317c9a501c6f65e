#pragma once

#include "symscene/calibration/depth_calibration.hpp"
#include "symscene/calibration/intrinsic_calibration.hpp"
#include "symscene/simulation/camera_errors.hpp"

namespace symscene::bench {

/// A simulated camera that is calibrated as a real one is.
struct CameraToCalibrate {
  CameraIntrinsics intrinsics;
  CameraErrorOptions errors;
};

/// That of the simulated sweeps, with a lens of moderate distortion and a depth error of `bias` at
/// 2 m.
CameraToCalibrate simulated_camera(double bias, std::uint64_t pattern);

/// Intrinsics from `images` images of a board with corners off by `noise` px.
IntrinsicCalibration found_intrinsics(const CameraToCalibrate& camera, int images, double noise,
                                      std::uint64_t seed);

/// Depth images of a wall from 0.5 to 2.2 m with the noise of the sensor, undistorted by
/// `calibrated`. The plane of the wall is that of a board on it, by corners off by 0.1 px, or not
/// known.
DepthCalibration found_depth(const CameraToCalibrate& camera, const CameraModel& calibrated,
                             int views, bool has_board, std::uint64_t seed);

/// Errors of noise-free depth images of walls at one distance, turned to several sides, over depth.
struct WallErrors {
  double absolute = 0.0;  ///< root mean square
  double warp = 0.0;      ///< the same from the plane that fits best
};
WallErrors wall_errors(const CameraToCalibrate& camera, const CameraModel& calibrated,
                       double distance);

}  // namespace symscene::bench
