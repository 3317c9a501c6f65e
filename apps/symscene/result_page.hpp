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

/// What a page shows beside a result.
struct PageExtras {
  std::optional<PageGrasps> grasps = std::nullopt;
  std::optional<PageViews> views = std::nullopt;
  std::vector<PageTruth> truth = {};
  std::string subject;          ///< what the page shows of the objects, told in its title
  std::string noun = "object";  ///< what the page calls an object
};

/// The page of a result with its table, its surface and the camera's path.
PageOptions result_page(const SegmentationResult& result, std::string title, Surroundings around);

/// Writes the page of a result that was made of `source`, which gives its title.
void write_result_page(const std::filesystem::path& page, const std::filesystem::path& source,
                       const SegmentationResult& result, Surroundings around,
                       PageExtras extras = {});

}  // namespace symscene::app
