#pragma once

#include "session.hpp"
#include "symscene/io/result.hpp"

namespace symscene::app {

/// What a scene folder has to show around the objects of its result: the part of mesh.ply that the
/// page shows, and poses.txt. Segmentation needs neither: what is wrong with them is a warning.
Surroundings scene_surroundings(const std::filesystem::path& scene,
                                const SegmentationResult& result, Session& session);

}  // namespace symscene::app
