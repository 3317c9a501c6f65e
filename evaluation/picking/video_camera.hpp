#pragma once

#include "symscene/core/camera.hpp"
#include "symscene/picking/run_video.hpp"

namespace symscene {

/// A camera that does not move.
struct VideoCamera {
  CameraIntrinsics intrinsics;
  Eigen::Isometry3d T_table_camera = Eigen::Isometry3d::Identity();
};

/// The camera of a video: opposite the robot and above, as near as it sees the table, the bin, the
/// robot and its hand at all moments. Objects are left out, as they may fall to the floor.
VideoCamera video_camera(const RunRecording& recording, const RunVideoOptions& options);

}  // namespace symscene
