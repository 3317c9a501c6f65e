#pragma once

#include "session.hpp"
#include "symscene/io/result.hpp"

namespace symscene::app {

/// What the page shows around the objects of a result: a part of the scene's mesh.ply, and
/// poses.txt. Segmentation needs neither, so that an invalid file is a warning.
Surroundings scene_surroundings(const std::filesystem::path& scene,
                                const SegmentationResult& result, Session& session);

}  // namespace symscene::app
