#pragma once

#include <optional>

#include "symscene/core/depth_frame.hpp"
#include "symscene/io/sequence.hpp"

namespace symscene::app {

/// The pose of frame i of a sequence in the frame of a result: of the result's trajectory at the
/// time of the frame, within a millisecond, otherwise of the sequence. A sequence of one frame
/// without pose is itself the frame of the result.
std::optional<Eigen::Isometry3d> frame_pose(const Trajectory& trajectory,
                                            const DepthSequence& sequence, std::size_t i);

}  // namespace symscene::app
