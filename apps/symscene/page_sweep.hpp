#pragma once

#include <vector>

#include "symscene/io/sequence.hpp"
#include "symscene/viewer/page.hpp"

namespace symscene::app {

/// At most 60 frames of a sequence, evenly spread over those with a pose in the frame of a result
/// with this trajectory, for the page. Throws InputError naming `path` if no frame has one.
std::vector<PageFrame> page_sweep(const DepthSequence& sequence, const Trajectory& trajectory,
                                  const std::filesystem::path& path);

}  // namespace symscene::app
