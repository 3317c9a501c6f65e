#pragma once

#include <optional>
#include <string>

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

/// What a page shows beside a result.
struct PageExtras {
  std::optional<PageGrasps> grasps = std::nullopt;
  std::optional<PageViews> views = std::nullopt;
  std::string noun = "object";  ///< what the page calls an object
};

/// Writes the page of a result that was made of `source`, which gives its title.
void write_result_page(const std::filesystem::path& page, const std::filesystem::path& source,
                       const SegmentationResult& result, Surroundings around,
                       PageExtras extras = {});

}  // namespace symscene::app
