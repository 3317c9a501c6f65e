#pragma once

#include <optional>
#include <string>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

struct PageOptions {
  // Every field has an initialiser, so that callers may name only some without a warning.
  std::string title = "Segmentation";
  std::string note = {};                             ///< a line under it: how the result was made
  std::optional<Plane> table = std::nullopt;         ///< normal is up and the grid lies on it
  std::optional<Eigen::Vector3d> up = std::nullopt;  ///< without a table; otherwise the world's z
  TriangleMesh surface = {};   ///< that was reconstructed; shown as page_surface() leaves it
  Trajectory trajectory = {};  ///< of the camera

  void validate() const;  // throws InputError
};

/// One self-contained HTML page that shows the result: no file beside it, no network. Text in it
/// is shown as text, whatever characters it holds.
/// Throws InputError if a position is not finite, an index does not name a point of the cloud or
/// `completed` is neither empty nor one an object, or if the cloud does not lie on the surface.
std::string render_page(const SegmentationResult& result, const PageOptions& options = {});

/// The JSON that the page shows; arrays are little endian in base64 (viewer/README.md).
std::string page_payload(const SegmentationResult& result, const PageOptions& options = {});

}  // namespace symscene
