#pragma once

#include <optional>

#include "session.hpp"
#include "symscene/io/result.hpp"
#include "symscene/viewer/page.hpp"

namespace symscene::app {

/// The part of the surface in the folder `source` around the objects of a result; empty, with a
/// warning, if it does not belong to them.
TriangleMesh surface_around(const TriangleMesh& surface, const SegmentationResult& result,
                            const std::filesystem::path& source, Session& session);

/// The direction that a page without a table shows upwards: −y for a cloud that lies before a
/// camera at the origin that looks along +z; none for others.
std::optional<Eigen::Vector3d> camera_up(const PointCloud& cloud);

/// Writes the page of a result that was made of `source`, which gives its title. `noun`: what the
/// page calls an object.
void write_result_page(const std::filesystem::path& page, const std::filesystem::path& source,
                       const SegmentationResult& result, Surroundings around,
                       std::optional<PageGrasps> grasps = std::nullopt,
                       const std::string& noun = "object");

}  // namespace symscene::app
